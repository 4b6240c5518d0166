//! Laws of the layer stack.

use nacreous_nacre::{Index, LayerStack, MAX_LAYERS, NacreError};

fn stack(thickness_nm: Vec<f64>, protein_nm: f64) -> Result<LayerStack, NacreError> {
    let index = |n| Index::new("index", n, 0.0).unwrap();
    LayerStack::new(thickness_nm, protein_nm, index(1.53), index(1.43), index(1.0), index(1.53))
}

#[test]
fn one_to_five_thousand_layers() {
    assert_eq!(
        stack(vec![], 20.0).unwrap_err().to_string(),
        "the stack has 0 layers; allowed: 1 to 5000"
    );
    assert!(stack(vec![400.0; MAX_LAYERS], 20.0).is_ok());
    assert_eq!(stack(vec![400.0; MAX_LAYERS + 1], 20.0), Err(NacreError::LayerCount(5001)));
}

#[test]
fn a_bad_thickness_is_named_by_its_place() {
    for bad in [0.0, -3.0, f64::NAN, f64::INFINITY] {
        let message = stack(vec![400.0, bad], 20.0).unwrap_err().to_string();
        assert!(message.starts_with("thickness_nm[1] is "), "{message}");
    }
    assert!(stack(vec![400.0], f64::NAN).unwrap_err().to_string().starts_with("protein_nm is NaN"));
}

#[test]
fn an_index_neither_vanishes_nor_amplifies() {
    assert!(Index::new("protein", 0.0, 0.0).is_err());
    assert!(Index::new("protein", f64::NAN, 0.0).is_err());
    assert_eq!(
        Index::new("protein", 1.43, -0.1).unwrap_err().to_string(),
        "protein: k is -0.1; allowed: 0 to 100"
    );
}

#[test]
fn outer_layers_are_those_that_begin_within_the_depth() {
    // Tops at 0, 420, 840 and 1260 nm.
    let even = stack(vec![400.0; 4], 20.0).unwrap();
    assert_eq!(even.outer(0.8).layers, 2);
    assert_eq!(even.outer(0.0).layers, 1);
    let uneven = stack(vec![300.0, 500.0], 20.0).unwrap().outer(10.0);
    assert_eq!((uneven.layers, uneven.mean_nm, uneven.spread_nm), (2, 400.0, 100.0));
}
