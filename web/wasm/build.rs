//! The stack of the module, which its ceilings count on; and no names of functions, a fifteenth of its
//! compressed size.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_ARCH").as_deref() == Ok("wasm32") {
        println!("cargo:rustc-link-arg-cdylib=-zstack-size=67108864");
        println!("cargo:rustc-link-arg-cdylib=--strip-all");
    }
}
