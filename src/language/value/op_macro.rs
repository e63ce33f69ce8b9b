//! The macro `op!`, by which a file declares its operation: it makes the [`Op`](super::Op) that all others read.

/// Declares an operation: this block is its only declaration.
///
/// Expands to a `struct Args` with one field a parameter and to `static OP: Op`, which the
/// family's list names. The file then defines `fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<R>`.
macro_rules! op {
    (
        $(#[doc = $docs:literal])+
        $name:ident $(| $alias:ident)* in $family:ident -> $returns:ty {
            $( $(#[doc = $pdocs:literal])+ $param:ident : $ty:ty $(= $default:expr)? ,)*
        }
        $( example $code:literal => $prints:literal; )+
        $( refuses $misuse:literal => $says:literal; )*
        $( encloses $enclosed:path; )?
        $( on_numbers $numbers:expr; )?
        $( on_vectors $vectors:expr; )?
        $( derivative $affine:ident $( unless $own:path )?; )?
        $( settling $settling:path; )?
        $( picture $picture:literal; )?
        $( scene $scene:literal; )?
        $( names $named:literal; )?
    ) => {
        struct Args { $( $param: $ty, )* }

        pub(in $crate::ops) static OP: $crate::value::Op = $crate::value::Op {
            name: stringify!($name),
            aliases: &[ $( stringify!($alias) ),* ],
            family: $crate::value::Family::$family,
            docs: concat!($($docs, "\n"),+),
            params: &[ $( $crate::value::OpParameter {
                name: stringify!($param),
                docs: concat!($($pdocs, "\n"),+),
                ty: <$ty as $crate::value::FromValue>::TYPE,
                default: $crate::value::op!(@thunk $ty $(, $default)?),
                optional: <$ty as $crate::value::FromValue>::OPTIONAL,
                spreads: <$ty as $crate::value::FromValue>::SPREADS,
                by_position: <$ty as $crate::value::FromValue>::BY_POSITION,
            } ),* ],
            returns: <$returns as $crate::value::IntoValue>::RETURNS,
            examples: &[ $( $crate::value::Example { code: $code, prints: $prints } ),+ ],
            refusals: &[ $( $crate::value::RefusalExample { code: $misuse, says: $says } ),* ],
            enclosed: $crate::value::op!(@enclosed $($enclosed)?),
            on_numbers: $crate::value::op!(@value $($numbers)?),
            on_vectors: $crate::value::op!(@value $($vectors)?),
            is_affine: $crate::value::op!(@is_affine $($affine)?),
            is_of_shape: $crate::value::op!(@is_of_shape $($affine)?),
            has_given_control_points: $crate::value::op!(@has_given_control_points $($affine)?),
            derives_itself: $crate::value::op!(@derives_itself $( $($own)? )?),
            settling: $crate::value::op!(@settling $($settling)?),
            picture: $crate::value::op!(@picture $(Value $picture)? $(Scene $scene)?),
            names_script: $crate::value::op!(@names_script $($named)?),
            run: |ctx, call| {
                let mut binder = $crate::value::Binder::new(
                    &OP, call, ctx.limits.list_length, (ctx.sources, ctx.unit),
                );
                $( let $param: Option<$ty> =
                    binder.take(stringify!($param), $crate::value::op!(@value $($default)?)); )*
                match ($($param,)*) {
                    ($(Some($param),)*) if binder.is_well() => {
                        run(ctx, Args { $($param),* }).map($crate::value::IntoValue::into_value)
                    }
                    _ => Err(binder.complaint()),
                }
            },
        };
    };
    (@thunk $ty:ty) => { None };
    (@thunk $ty:ty, $default:expr) => { Some(|| {
        let default: $ty = $default;
        $crate::value::IntoValue::into_value(default)
    }) };
    (@enclosed) => { None };
    (@enclosed $enclosed:path) => { Some($enclosed) };
    (@is_affine) => { false };
    (@is_affine affine) => { true };
    (@is_affine control_points) => { true };
    (@is_affine shape) => { true };
    (@is_of_shape) => { false };
    (@is_of_shape affine) => { false };
    (@is_of_shape control_points) => { false };
    (@is_of_shape shape) => { true };
    (@has_given_control_points) => { false };
    (@has_given_control_points affine) => { false };
    (@has_given_control_points control_points) => { true };
    (@has_given_control_points shape) => { false };
    (@derives_itself) => { None };
    (@derives_itself $own:path) => { Some($own) };
    (@settling) => { None };
    (@settling $settling:path) => { Some(&$settling) };
    (@picture) => { None };
    (@picture $kind:ident $picture:literal) => { Some($crate::value::ExamplePicture::$kind($picture)) };
    (@names_script) => { false };
    (@names_script $named:literal) => { true };
    (@value) => { None };
    (@value $default:expr) => { Some($default) };
}
pub(crate) use op;
