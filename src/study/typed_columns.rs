//! Results as Parquet: a column each, typed by what is in it, in groups of rows that fit into memory.

use std::{
    fs::File,
    io::{self, Write},
    path::Path,
    sync::{Arc, Mutex, PoisonError},
};

use parquet::{
    basic::{Compression, LogicalType, Repetition, Type as PhysicalType},
    data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type},
    errors::ParquetError,
    file::{
        properties::WriterProperties,
        reader::{FileReader, SerializedFileReader},
        writer::{SerializedFileWriter, SerializedRowGroupWriter},
    },
    record::Field,
    schema::types::Type,
};
use serde_json::Value as Json;

use super::{
    columns::{CellKind, ResultColumns, text_of},
    row::Row,
};
use crate::export::io_reason;

/// Rows that are held at a time.
const ROWS_A_GROUP: usize = 10_000;

/// Writes rows, of which these are the columns.
pub(super) fn write(
    columns: &ResultColumns,
    rows: &mut dyn Iterator<Item = io::Result<Row>>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let fields = columns.iter().map(|(title, kind)| field(title, kind).map(Arc::new));
    let fields = fields.collect::<Result<_, _>>().map_err(io::Error::other)?;
    let schema = Type::group_type_builder("study").with_fields(fields).build();
    let schema = Arc::new(schema.map_err(io::Error::other)?);
    let properties = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_created_by(format!("virote {}", env!("CARGO_PKG_VERSION")))
        .build();
    let written = Written::default();
    let writer = SerializedFileWriter::new(written.clone(), schema, Arc::new(properties));
    let mut writer = writer.map_err(reason)?;
    loop {
        let group: Vec<Row> = (&mut *rows).take(ROWS_A_GROUP).collect::<io::Result<_>>()?;
        if group.is_empty() {
            break;
        }
        let mut row_group = writer.next_row_group().map_err(reason)?;
        for (title, kind) in columns.iter() {
            let cells = group.iter().map(|row| row.get(title).unwrap_or(&Json::Null));
            add_column(&mut row_group, kind, cells).map_err(reason)?;
        }
        row_group.close().map_err(reason)?;
        written.pass_on(out)?;
    }
    writer.close().map_err(reason)?;
    written.pass_on(out)
}

/// What the library has written and is not passed on yet; it asks for a writer that goes to other threads.
#[derive(Clone, Default)]
struct Written(Arc<Mutex<Vec<u8>>>);

impl Written {
    fn pass_on(&self, out: &mut dyn Write) -> io::Result<()> {
        let bytes = std::mem::take(&mut *self.0.lock().unwrap_or_else(PoisonError::into_inner));
        out.write_all(&bytes)
    }
}

impl Write for Written {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn field(title: &str, kind: CellKind) -> Result<Type, ParquetError> {
    let physical = match kind {
        CellKind::Integer => PhysicalType::INT64,
        CellKind::Number => PhysicalType::DOUBLE,
        CellKind::Bool => PhysicalType::BOOLEAN,
        CellKind::Text | CellKind::Empty => PhysicalType::BYTE_ARRAY,
    };
    let builder = Type::primitive_type_builder(title, physical);
    let builder = match physical {
        PhysicalType::BYTE_ARRAY => builder.with_logical_type(Some(LogicalType::String)),
        _ => builder,
    };
    builder.with_repetition(Repetition::OPTIONAL).build()
}

fn add_column<'c>(
    out: &mut SerializedRowGroupWriter<'_, Written>,
    kind: CellKind,
    cells: impl Iterator<Item = &'c Json>,
) -> Result<(), ParquetError> {
    match kind {
        CellKind::Integer => add::<Int64Type>(out, cells.map(Json::as_i64)),
        CellKind::Number => add::<DoubleType>(out, cells.map(Json::as_f64)),
        CellKind::Bool => add::<BoolType>(out, cells.map(Json::as_bool)),
        CellKind::Text | CellKind::Empty => {
            let texts =
                cells.map(|cell| text_of(cell).map(|text| ByteArray::from(text.into_bytes())));
            add::<ByteArrayType>(out, texts)
        }
    }
}

/// Writes the next column; a cell that is not there is null.
fn add<T: DataType>(
    out: &mut SerializedRowGroupWriter<'_, Written>,
    cells: impl Iterator<Item = Option<T::T>>,
) -> Result<(), ParquetError> {
    let (mut values, mut levels) = (Vec::new(), Vec::new());
    for cell in cells {
        levels.push(i16::from(cell.is_some()));
        values.extend(cell);
    }
    let Some(mut column) = out.next_column()? else { return Ok(()) };
    column.typed::<T>().write_batch(&values, Some(&levels), None)?;
    column.close()
}

fn reason(err: ParquetError) -> io::Error {
    io::Error::other(err)
}

/// The rows of a Parquet file of results.
///
/// # Errors
/// Why it cannot be read.
pub fn read_results(path: &Path) -> Result<Vec<Row>, String> {
    let cannot = |why: String| format!("cannot read `{}`: {why}", path.display());
    let file = File::open(path).map_err(|err| cannot(io_reason(&err)))?;
    let reader = SerializedFileReader::new(file).map_err(|err| cannot(err.to_string()))?;
    let rows = reader.get_row_iter(None).map_err(|err| cannot(err.to_string()))?;
    rows.map(|row| {
        let row = row.map_err(|err| cannot(err.to_string()))?;
        let cells = row.get_column_iter().map(|(title, field)| (title.clone(), cell_of(field)));
        Ok(cells.collect())
    })
    .collect()
}

fn cell_of(field: &Field) -> Json {
    match field {
        Field::Bool(truth) => Json::from(*truth),
        Field::Long(whole) => Json::from(*whole),
        Field::Double(number) => Json::from(*number),
        Field::Str(text) => Json::from(text.as_str()),
        _ => Json::Null,
    }
}
