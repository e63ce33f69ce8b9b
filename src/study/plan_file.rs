//! Plans in files: CSV as spreadsheets write it, or Parquet. Read row by row, so that a long one takes
//! no memory.

use std::{
    fs::File,
    io::{BufRead, BufReader, Seek},
    path::{Path, PathBuf},
};

use parquet::{
    data_type::Decimal,
    file::reader::{FileReader, SerializedFileReader},
    record::Field,
};

use super::closed_quotes::ClosedQuotes;
use crate::{export::io_reason, value::shortest};

/// A file with a row for each variant.
#[derive(Debug)]
pub(super) struct PlanFile {
    path: PathBuf,
    layout: PlanLayout,
    titles: Vec<String>,
}

#[derive(Clone, Copy, Debug)]
enum PlanLayout {
    /// Separated by this.
    Csv(u8),
    Parquet,
}

/// The cells of a variant.
#[derive(Debug)]
pub(super) struct PlanRow {
    /// How a message about it begins; empty where it has no place.
    pub(super) place: String,
    /// None is missing.
    pub(super) cells: Vec<Option<String>>,
}

/// How a Parquet file begins.
const PARQUET: &[u8] = b"PAR1";

impl PlanFile {
    /// The file, with the titles of its columns.
    ///
    /// # Errors
    /// A sentence that names the file.
    pub(super) fn open(path: &Path) -> Result<Self, String> {
        let name = path.display();
        let cannot = |why: String| format!("cannot read `{name}`: {why}");
        let data = path.metadata().map_err(|err| cannot(io_reason(&err)))?;
        if !data.is_file() {
            return Err(format!(
                "`{name}` is no file: a plan is read twice, so it cannot be a pipe"
            ));
        }
        let file = File::open(path).map_err(|err| cannot(io_reason(&err)))?;
        let mut start = BufReader::new(file);
        let begin = start.fill_buf().map_err(|err| cannot(io_reason(&err)))?;
        if begin.starts_with(PARQUET) {
            let reader = parquet_reader(path)?;
            let fields = reader.metadata().file_metadata().schema().get_fields();
            let titles = fields.iter().map(|field| field.name().to_owned()).collect();
            return Ok(Self { path: path.to_owned(), layout: PlanLayout::Parquet, titles });
        }
        let header_end = begin.iter().position(|byte| b"\r\n".contains(byte));
        let header = &begin[..header_end.unwrap_or(begin.len())];
        if header.trim_ascii().is_empty() {
            return Err(format!("the plan `{name}` is empty: its first line names the parameters"));
        }
        let separator = *b",;\t".iter().find(|byte| header.contains(byte)).unwrap_or(&b',');
        let layout = PlanLayout::Csv(separator);
        let mut file = Self { path: path.to_owned(), layout, titles: Vec::new() };
        start.rewind().map_err(|err| cannot(io_reason(&err)))?;
        let mut reader = csv_reader(start, separator);
        let header = reader.headers().map_err(|err| file.csv_fault(&err))?;
        file.titles = header.iter().map(str::to_owned).collect();
        Ok(file)
    }

    /// The titles of its columns.
    pub(super) fn titles(&self) -> &[String] {
        &self.titles
    }

    /// The rows in their order.
    pub(super) fn rows(&self) -> Box<dyn Iterator<Item = Result<PlanRow, String>> + Send + '_> {
        match self.layout {
            PlanLayout::Csv(separator) => match File::open(&self.path) {
                Ok(file) => self.csv_rows(file, separator),
                Err(err) => {
                    let name = self.path.display();
                    let message = format!("cannot read `{name}`: {}", io_reason(&err));
                    Box::new(std::iter::once(Err(message)))
                }
            },
            PlanLayout::Parquet => match parquet_reader(&self.path) {
                Ok(reader) => self.parquet_rows(reader),
                Err(message) => Box::new(std::iter::once(Err(message))),
            },
        }
    }

    fn csv_rows(
        &self,
        file: File,
        separator: u8,
    ) -> Box<dyn Iterator<Item = Result<PlanRow, String>> + Send + '_> {
        let mut reader = csv_reader(BufReader::new(file), separator);
        match reader.headers() {
            Ok(header) if header.iter().eq(&self.titles) => {}
            Ok(_) => return Box::new(std::iter::once(Err(self.other_header()))),
            Err(err) => return Box::new(std::iter::once(Err(self.csv_fault(&err)))),
        }
        let quoted = reader.get_ref().quoted_cells();
        let mut records = reader.into_byte_records();
        let mut is_first = true;
        let rows = std::iter::from_fn(move || {
            let record = records.next()?;
            if std::mem::take(&mut is_first) {
                // That of the header.
                quoted.next_row();
            }
            Some((record, quoted.next_row()))
        });
        Box::new(rows.map(|(record, quoted)| {
            let record = record.map_err(|err| self.csv_fault(&err))?;
            let line = record.position().map_or(0, csv::Position::line);
            let place = format!("{}:{line}: ", self.path.display());
            // An empty cell is a text where it is in quotes, else nothing.
            let cells = record.iter().enumerate().map(|(i, cell)| {
                let is_there = !cell.is_empty() || quoted.contains(&i);
                str::from_utf8(cell).map(|cell| is_there.then(|| cell.to_owned()))
            });
            match cells.collect() {
                Ok(cells) => Ok(PlanRow { place, cells }),
                Err(_) => Err(format!("{place}the row is not UTF-8 text; save the plan as UTF-8")),
            }
        }))
    }

    fn parquet_rows(
        &self,
        reader: SerializedFileReader<File>,
    ) -> Box<dyn Iterator<Item = Result<PlanRow, String>> + Send + '_> {
        let fields = reader.metadata().file_metadata().schema().get_fields();
        if !fields.iter().map(|field| field.name()).eq(&self.titles) {
            return Box::new(std::iter::once(Err(self.other_header())));
        }
        let name = self.path.display();
        let groups = 0..reader.num_row_groups();
        let rows = groups.flat_map(move |group| -> Vec<Result<PlanRow, String>> {
            // Groups are what a writer held in memory.
            let rows =
                reader.get_row_group(group).and_then(|group| group.get_row_iter(None)?.collect());
            let rows: Vec<parquet::record::Row> = match rows {
                Ok(rows) => rows,
                Err(err) => return vec![Err(format!("cannot read `{name}`: {err}"))],
            };
            rows.iter().enumerate().map(|(i, row)| self.parquet_row(group, i, row)).collect()
        });
        Box::new(rows)
    }

    fn parquet_row(
        &self,
        group: usize,
        i: usize,
        row: &parquet::record::Row,
    ) -> Result<PlanRow, String> {
        let place = format!("{}, row {} of group {group}: ", self.path.display(), i + 1);
        let cells = row.get_column_iter().map(|(title, field)| {
            text_of(field).ok_or_else(|| {
                format!("{place}column `{title}` holds neither numbers nor texts nor truth values")
            })
        });
        let cells = cells.collect::<Result<_, _>>()?;
        Ok(PlanRow { place, cells })
    }

    /// What a file says that was another one before.
    fn other_header(&self) -> String {
        format!("the columns of `{}` are other ones", self.path.display())
    }

    /// What the reader of CSV complains of, in the words of its user.
    fn csv_fault(&self, err: &csv::Error) -> String {
        let name = self.path.display();
        match err.kind() {
            csv::ErrorKind::UnequalLengths { pos, expected_len, len } => {
                let line = pos.as_ref().map_or(0, csv::Position::line);
                let cells = if *len == 1 { "cell" } else { "cells" };
                format!("{name}:{line}: the row has {len} {cells}, the header has {expected_len}")
            }
            csv::ErrorKind::Utf8 { .. } => {
                format!("{name}:1: the header is not UTF-8 text; save the plan as UTF-8")
            }
            csv::ErrorKind::Io(err) => format!("cannot read `{name}`: {}", io_reason(err)),
            _ => format!("cannot read `{name}`: {err}"),
        }
    }
}

fn csv_reader<R: std::io::Read>(file: R, separator: u8) -> csv::Reader<ClosedQuotes<R>> {
    let file = ClosedQuotes::new(file, separator);
    csv::ReaderBuilder::new().delimiter(separator).trim(csv::Trim::Headers).from_reader(file)
}

fn parquet_reader(path: &Path) -> Result<SerializedFileReader<File>, String> {
    let name = path.display();
    let file =
        File::open(path).map_err(|err| format!("cannot read `{name}`: {}", io_reason(&err)))?;
    SerializedFileReader::new(file).map_err(|err| format!("cannot read `{name}`: {err}"))
}

/// What files call what is not a number.
const NOT_A_NUMBER: &str = "nan";

/// A decimal number of a hundred and twenty-eight bits or fewer, with all its digits.
fn decimal_text(decimal: &Decimal) -> Option<String> {
    let bytes = decimal.data();
    let scale = usize::try_from(decimal.scale()).ok()?;
    let mut all = [if bytes.first()? & 0x80 == 0 { 0 } else { 0xff }; 16];
    all[16_usize.checked_sub(bytes.len())?..].copy_from_slice(bytes);
    let value = i128::from_be_bytes(all);
    let digits = format!("{:0width$}", value.unsigned_abs(), width = scale + 1);
    let (whole, part) = digits.split_at(digits.len() - scale);
    let sign = if value < 0 { "-" } else { "" };
    let point = if part.is_empty() { "" } else { "." };
    Some(format!("{sign}{whole}{point}{part}"))
}

/// A cell as CSV would have it, none inside for null; none where it is no plain value.
fn text_of(field: &Field) -> Option<Option<String>> {
    Some(Some(match field {
        Field::Null => return Some(None),
        Field::Bool(truth) => truth.to_string(),
        Field::Byte(n) => n.to_string(),
        Field::Short(n) => n.to_string(),
        Field::Int(n) => n.to_string(),
        Field::Long(n) => n.to_string(),
        Field::UByte(n) => n.to_string(),
        Field::UShort(n) => n.to_string(),
        Field::UInt(n) => n.to_string(),
        Field::ULong(n) => n.to_string(),
        // Not a number is no missing value: the script refuses it.
        Field::Float(x) if x.is_nan() => NOT_A_NUMBER.to_owned(),
        Field::Double(x) if x.is_nan() => NOT_A_NUMBER.to_owned(),
        Field::Float(x) => x.to_string(),
        Field::Double(x) => shortest(*x),
        Field::Decimal(decimal) => decimal_text(decimal)?,
        Field::Str(text) => text.clone(),
        _ => return None,
    }))
}

#[cfg(test)]
mod tests {
    use parquet::data_type::{ByteArray, Decimal};

    use super::decimal_text;

    #[test]
    fn decimals_keep_their_digits() {
        let of = |value: i128, scale: i32| {
            let bytes = ByteArray::from(value.to_be_bytes().to_vec());
            decimal_text(&Decimal::from_bytes(bytes, 38, scale)).unwrap_or_default()
        };
        assert_eq!(of(12345, 2), "123.45");
        assert_eq!(of(-5, 3), "-0.005");
        assert_eq!(of(-120, 0), "-120");
        assert_eq!(of(i128::MIN, 38), "-1.70141183460469231731687303715884105728");
        assert_eq!(decimal_text(&Decimal::from_i32(-7, 9, 1)).as_deref(), Some("-0.7"));
        let wide = ByteArray::from(vec![0; 17]);
        assert_eq!(decimal_text(&Decimal::from_bytes(wide, 40, 0)), None);
    }
}
