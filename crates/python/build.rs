//! A wheel has the study's pages if they were built before it; what builds one says so where not.

fn main() {
    let first = "../../nacreous/server/pages/index.html";
    println!("cargo::rerun-if-changed={first}");
    if !std::path::Path::new(first).is_file() {
        println!(
            "cargo::warning=The study's pages are not built: a wheel made now serves no study. \
             `./just wheel` builds them first."
        );
    }
}
