//! Values as keys: bytes that agree where the values are the same in every bit, and nowhere else.

use super::{Function, Number, Value};

/// Appends the exact key of `value`: its kind, then every bit of it, dimensions included. Texts tell
/// their length first, so that keys put one behind the other stay apart.
///
/// Values of a parameter, literals and built-ins are spelled bit by bit; any other value by all digits of
/// all its fields.
pub(crate) fn exact_key(value: &Value, key: &mut Vec<u8>) {
    match value {
        Value::None => key.push(0),
        Value::Bool(truth) => key.extend([1, u8::from(*truth)]),
        Value::Number(Number { value, dim }) => {
            key.push(2);
            key.extend(value.to_bits().to_le_bytes());
            key.push(u8::from(dim.length_power().is_none()));
            let powers = [dim.length_power().unwrap_or(0), dim.angle_power()];
            key.extend(powers.map(i8::cast_unsigned));
        }
        Value::Text(text) => tagged_text(3, text, key),
        Value::Function(Function::Builtin(name, _)) => tagged_text(4, name, key),
        other => tagged_text(5, &format!("{other:?}"), key),
    }
}

fn tagged_text(tag: u8, text: &str, key: &mut Vec<u8>) {
    key.push(tag);
    key.extend((text.len() as u64).to_le_bytes());
    key.extend(text.as_bytes());
}

#[cfg(test)]
mod tests {
    use super::{super::Dimension, Number, Value, exact_key};

    fn key(value: &Value) -> Vec<u8> {
        let mut key = Vec::new();
        exact_key(value, &mut key);
        key
    }

    #[test]
    fn numbers_of_other_dimensions_have_other_keys() {
        let keys: Vec<_> = [Dimension::NONE, Dimension::LENGTH, Dimension::ANGLE, Dimension::OPEN]
            .map(|dim| key(&Value::Number(Number { value: 5.0, dim })))
            .into();
        let distinct: std::collections::HashSet<_> = keys.iter().collect();
        assert_eq!(distinct.len(), keys.len());
        assert_eq!(key(&Value::number(5.0)), keys[0]);
        assert_ne!(key(&Value::number(0.0)), key(&Value::number(-0.0)));
        assert_ne!(key(&Value::text("5")), keys[0]);
    }
}
