//! What was made before, kept by what it was made from.

use std::sync::Arc;

/// Values by their keys; of those, only what the last call asked for.
#[derive(Debug)]
pub(crate) struct Kept<K, V>(Vec<(K, Arc<V>)>);

/// Something shared, equal to nothing but itself: a cheap key for what is made from it.
#[derive(Debug)]
pub(crate) struct Same<T>(pub(crate) Arc<T>);

impl<T> Clone for Same<T> {
    fn clone(&self) -> Self {
        Self(Arc::clone(&self.0))
    }
}

impl<T> PartialEq for Same<T> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl<K, V> Default for Kept<K, V> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<K: PartialEq, V> Kept<K, V> {
    /// The value of each key: what is kept, else what `make` gives; equal keys share it. `None` as soon as
    /// `make` gives none, which happens where it was asked to stop; what it made before that is kept too.
    pub(crate) fn all<E>(
        &mut self,
        keys: Vec<K>,
        make: impl Fn(&K) -> Result<Option<V>, E>,
    ) -> Result<Option<Vec<Arc<V>>>, E> {
        let mut used: Vec<(K, Arc<V>)> = Vec::new();
        let mut found = Vec::with_capacity(keys.len());
        for key in keys {
            let known = used.iter().chain(&self.0).find(|(known, _)| *known == key);
            let value = if let Some((_, value)) = known {
                value.clone()
            } else {
                let Some(value) = make(&key)? else {
                    self.0.extend(used);
                    return Ok(None);
                };
                Arc::new(value)
            };
            found.push(value.clone());
            if !used.iter().any(|(known, _)| *known == key) {
                used.push((key, value));
            }
        }
        self.0 = used;
        Ok(Some(found))
    }

    /// Whether the value of a key is kept.
    pub(crate) fn has(&self, key: &K) -> bool {
        self.0.iter().any(|(known, _)| known == key)
    }

    /// Keeps a value that was made elsewhere.
    pub(crate) fn put(&mut self, key: K, value: V) {
        self.0.push((key, Arc::new(value)));
    }

    /// The value of one key.
    pub(crate) fn one<E>(
        &mut self,
        key: K,
        make: impl Fn(&K) -> Result<Option<V>, E>,
    ) -> Result<Option<Arc<V>>, E> {
        Ok(self.all(vec![key], make)?.and_then(|values| values.into_iter().next()))
    }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;

    use super::*;

    #[test]
    fn each_key_is_made_once_and_again_only_after_it_was_not_asked_for() {
        let (mut kept, made) = (Kept::default(), RefCell::new(Vec::new()));
        let mut ask = |keys: &[i32]| {
            let make = |key: &i32| {
                made.borrow_mut().push(*key);
                Ok::<_, ()>(Some(10 * key))
            };
            let found = kept.all(keys.to_vec(), make).unwrap().unwrap();
            found.iter().map(|value| **value).collect::<Vec<_>>()
        };
        assert_eq!(ask(&[1, 2, 1]), [10, 20, 10]);
        assert_eq!(ask(&[2, 3]), [20, 30]);
        assert_eq!(ask(&[1]), [10]);
        assert_eq!(*made.borrow(), [1, 2, 3, 1]);
    }

    #[test]
    fn what_was_kept_outlives_a_stop() {
        let mut kept = Kept::default();
        let make = |stopped: bool| move |key: &i32| Ok::<_, ()>((!stopped).then_some(*key));
        kept.one(1, make(false)).unwrap().unwrap();
        assert_eq!(kept.all(vec![1, 2], make(true)), Ok(None));
        assert_eq!(kept.one(1, make(true)).unwrap().as_deref(), Some(&1));
    }

    #[test]
    fn what_was_made_before_a_stop_is_not_made_again() {
        let mut kept = Kept::default();
        let until = |stop: i32| move |key: &i32| Ok::<_, ()>((*key < stop).then_some(*key));
        assert_eq!(kept.all(vec![1, 2, 3], until(3)), Ok(None));
        assert_eq!(kept.all(vec![1, 2], until(0)), Ok(Some(vec![Arc::new(1), Arc::new(2)])));
    }
}
