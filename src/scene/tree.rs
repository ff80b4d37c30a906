//! Serde over a parsed TOML file: what is wrong is told with its address, in words for people.
//!
//! It is stricter than serde's usual ways (a struct is a table and never a list, an array has as many
//! items as it should), and reads in forms of its own what attributes such as `flatten` and
//! `untagged` would read without addresses and refusals:
//!
//! * an enum is a table with one of the keys that name its variants; what is chosen by them is the
//!   enum's own name, such as `#[serde(rename = "kind of light")]`;
//! * a field whose name begins with `a `, such as `#[serde(rename = "a shape")]`, is an enum whose key
//!   stands beside the struct's other keys;
//! * a variant whose name begins with `a `, such as `#[serde(rename = "a colour")]`, is what stands there
//!   if that is no table;
//! * a tuple struct is a list of numbers, or one number for all; its name is what is expected there.

use super::field::{Checked, Problem, Within};
use super::read::guess;
use serde::de::value::SeqDeserializer;
use serde::de::{
    self, Deserialize, DeserializeSeed, Deserializer, EnumAccess, Expected, IntoDeserializer,
    MapAccess, SeqAccess, Unexpected, VariantAccess, Visitor,
};
use std::convert::Infallible;
use std::fmt::{self, Display};
use std::iter::{Enumerate, repeat_n};
use std::{slice, vec};
use toml::Spanned;
use toml::de::DeValue;

impl de::Error for Problem {
    fn custom<T: Display>(what: T) -> Self {
        Problem::new(what.to_string())
    }

    fn invalid_type(found: Unexpected, expected: &dyn Expected) -> Self {
        let expected = expected.to_string();
        // What stands behind a semicolon is for the end of the sentence.
        let end = expected.find(';').unwrap_or(expected.len());
        let (expected, fields) = expected.split_at(end);
        let expected = match expected {
            "f64" => "a number",
            "i64" => "a whole number",
            "a sequence" => "a list",
            "a map" => "a table",
            "path string" => "a path in quotes",
            other => other,
        };
        let found = match found {
            Unexpected::Map => "a table".to_owned(),
            Unexpected::Seq => "a list".to_owned(),
            other => format!("the {other}").replace(" as i128", ""),
        };
        Problem::new(format!("must be {expected}, not {found}{fields}"))
    }

    fn unknown_field(name: &str, allowed: &'static [&'static str]) -> Self {
        unknown(name, allowed)
    }

    fn missing_field(name: &'static str) -> Self {
        Problem::new("is missing").within(name)
    }
}

fn unknown(name: &str, allowed: &[&str]) -> Problem {
    let quoted: Vec<String> = allowed.iter().map(|field| format!("`{field}`")).collect();
    let quoted = quoted.join(if allowed.len() == 2 { " or " } else { ", " });
    let meant = guess(name, allowed);
    Problem::new(format!("is not a field here; allowed: {quoted}{meant}"))
}

/// A visitor that expects something else, whatever comes.
struct Refusal<'a>(&'a str);

impl Visitor<'_> for Refusal<'_> {
    type Value = Infallible;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(self.0)
    }
}

/// What is read.
pub(super) enum Value<'a> {
    /// A value of the file.
    Said(&'a DeValue<'a>),
    /// Entries of a table one of which is to be given, and the names of the fields beside them.
    Choice(Vec<Entry<'a>>, Vec<&'static str>),
}

type Entry<'a> = (&'a str, Value<'a>);

impl<'a> Value<'a> {
    fn refused<T>(self, expected: &str) -> Checked<T> {
        self.deserialize_any(Refusal(expected))
            .map(|never| match never {})
    }

    /// The entries of a table that has these fields, and the names of fields beside them.
    fn entries(self, fields: &[&str]) -> Checked<(Vec<Entry<'a>>, Vec<&'static str>)> {
        match self {
            Value::Choice(entries, beside) => Ok((entries, beside)),
            Value::Said(DeValue::Table(table)) => {
                let all = table.iter();
                let all = all.map(|(key, value)| (&**key.get_ref(), Value::Said(value.get_ref())));
                Ok((all.collect(), Vec::new()))
            }
            other => other.refused(&format!("a table; its fields are {}", fields.join(", "))),
        }
    }

    fn list<'de, V: Visitor<'de>>(self, len: usize, what: &str, visitor: V) -> Checked<V::Value> {
        match self {
            Value::Said(DeValue::Array(list)) if list.len() != len => {
                Problem::of(format!("must be {what}, not {} of them", list.len()))
            }
            Value::Said(DeValue::Array(_)) => self.deserialize_any(visitor),
            other => other.refused(what),
        }
    }
}

impl<'de> Deserializer<'de> for Value<'_> {
    type Error = Problem;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Checked<V::Value> {
        let said = match self {
            Value::Choice(entries, _) => return visitor.visit_map(Entries::of(entries)),
            Value::Said(said) => said,
        };
        match said {
            DeValue::String(text) => visitor.visit_str(text),
            DeValue::Boolean(yes) => visitor.visit_bool(*yes),
            DeValue::Integer(x) => match i128::from_str_radix(x.as_str(), x.radix()) {
                Ok(x) => match i64::try_from(x) {
                    Ok(x) => visitor.visit_i64(x),
                    Err(_) => visitor.visit_i128(x),
                },
                Err(_) => Problem::of("overflows: no whole number is so large"),
            },
            DeValue::Float(x) => match x.as_str().parse::<f64>() {
                Ok(number) if number.is_finite() || x.as_str().ends_with(['f', 'n']) => {
                    visitor.visit_f64(number)
                }
                _ => Problem::of("overflows: no number is larger than 1.8e308"),
            },
            DeValue::Datetime(_) => {
                Err(de::Error::invalid_type(Unexpected::Other("date"), &visitor))
            }
            DeValue::Array(list) => visitor.visit_seq(Items(list.iter().enumerate())),
            DeValue::Table(_) => visitor.visit_map(Entries::of(Value::Said(said).entries(&[])?.0)),
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Checked<V::Value> {
        visitor.visit_some(self)
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Checked<V::Value> {
        // What is no table among tables is told before what a table lacks.
        if let Value::Said(DeValue::Array(list)) = self
            && list.first().is_some_and(|first| first.get_ref().is_table())
            && let Some(at) = list.iter().position(|item| !item.get_ref().is_table())
        {
            return Value::Said(list[at].get_ref())
                .refused("a table")
                .within(at);
        }
        self.deserialize_any(visitor)
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, len: usize, visitor: V) -> Checked<V::Value> {
        self.list(len, &format!("{len} numbers in brackets"), visitor)
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(
        self,
        expected: &'static str,
        len: usize,
        visitor: V,
    ) -> Checked<V::Value> {
        if let Value::Said(DeValue::Integer(_) | DeValue::Float(_)) = self {
            let same = repeat_n(f64::deserialize(self)?, len);
            return visitor.visit_seq(SeqDeserializer::new(same));
        }
        self.list(len, expected, visitor)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Checked<V::Value> {
        let (mut entries, _) = self.entries(fields)?;
        let (choice, beside): (Vec<&str>, Vec<&str>) =
            fields.iter().partition(|field| field.starts_with("a "));
        if let Some(name) = choice.first() {
            let (own, rest) = entries
                .into_iter()
                .partition(|(key, _)| beside.contains(key));
            entries = own;
            entries.push((name, Value::Choice(rest, beside)));
        }
        visitor.visit_map(Entries::of(entries))
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        what: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Checked<V::Value> {
        if let (Some(name), Value::Said(said)) =
            (variants.iter().find(|v| v.starts_with("a ")), &self)
            && !said.is_table()
        {
            return visitor.visit_enum(Variant(name, self));
        }
        let named: Vec<&str> = variants
            .iter()
            .copied()
            .filter(|v| !v.starts_with("a "))
            .collect();
        let variants = named.as_slice();
        let (mut entries, beside) = self.entries(variants)?;
        if let Some((key, _)) = entries.iter().find(|(key, _)| !variants.contains(key)) {
            return Err(unknown(key, &[&beside, variants].concat()).within(*key));
        }
        entries.sort_by_key(|(key, _)| variants.iter().position(|name| name == key));
        let mut given = entries.into_iter();
        match (given.next(), given.next()) {
            (Some((name, value)), None) => visitor.visit_enum(Variant(name, value)).within(name),
            (Some((a, _)), Some((b, _))) => {
                Problem::of(format!("has both {a} and {b}, but takes only one {what}"))
            }
            (None, _) => Problem::of(format!("needs a {what}: one of {}", variants.join(", "))),
        }
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit
        unit_struct newtype_struct map identifier ignored_any
    }
}

/// The items of a list.
struct Items<'a>(Enumerate<slice::Iter<'a, Spanned<DeValue<'a>>>>);

impl<'de> SeqAccess<'de> for Items<'_> {
    type Error = Problem;

    fn next_element_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Checked<Option<S::Value>> {
        let Some((i, item)) = self.0.next() else {
            return Ok(None);
        };
        seed.deserialize(Value::Said(item.get_ref()))
            .within(i)
            .map(Some)
    }
}

/// The entries of a table.
struct Entries<'a> {
    rest: vec::IntoIter<Entry<'a>>,
    next: Option<Entry<'a>>,
}

impl<'a> Entries<'a> {
    fn of(entries: Vec<Entry<'a>>) -> Self {
        let rest = entries.into_iter();
        Entries { rest, next: None }
    }
}

impl<'de> MapAccess<'de> for Entries<'_> {
    type Error = Problem;

    fn next_key_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Checked<Option<S::Value>> {
        self.next = self.rest.next();
        let Some((key, _)) = self.next else {
            return Ok(None);
        };
        seed.deserialize(key.into_deserializer())
            .within(key)
            .map(Some)
    }

    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Checked<S::Value> {
        match self.next.take() {
            Some((key, Value::Said(said))) => seed.deserialize(Value::Said(said)).within(key),
            Some((_, choice)) => seed.deserialize(choice),
            None => Problem::of("has a value without a key"),
        }
    }
}

/// A variant of an enum by its name, with what it holds.
struct Variant<'a>(&'a str, Value<'a>);

impl<'de, 'a> EnumAccess<'de> for Variant<'a> {
    type Error = Problem;
    type Variant = Value<'a>;

    fn variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Checked<(S::Value, Value<'a>)> {
        Ok((seed.deserialize(self.0.into_deserializer())?, self.1))
    }
}

impl<'de> VariantAccess<'de> for Value<'_> {
    type Error = Problem;

    fn unit_variant(self) -> Checked<()> {
        <()>::deserialize(self)
    }

    fn newtype_variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Checked<S::Value> {
        seed.deserialize(self)
    }

    fn tuple_variant<V: Visitor<'de>>(self, len: usize, visitor: V) -> Checked<V::Value> {
        self.deserialize_tuple(len, visitor)
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Checked<V::Value> {
        self.deserialize_struct("", fields, visitor)
    }
}
