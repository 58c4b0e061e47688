//! Bytes that are changed at random: whatever comes, no panic.

use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use softanvil_records::series::Table;
use softanvil_records::sheet::{self, Layout};
use softanvil_records::trace::{self, Options};

use crate::common::EXPECTED;
use crate::workbooks::{ods, xlsx};

fn seeds() -> Vec<Vec<u8>> {
    let rows: String = (0..40).map(|i| format!("{:.4},{:.2}\n", 1e-3 * f64::from(i), f64::from(i % 7))).collect();
    let tabs = rows.replace(',', "\t");
    vec![
        format!("# a drop\nMass,5.0,kg\ntime [s],force [N]\n{rows}Max,6\n").into_bytes(),
        format!("Zeit;Kraft\nms;kN\n{}", rows.replace(',', ";").replace('.', ",")).into_bytes(),
        format!("\"strain [%]\",\"stress [kPa]\"\n{rows}\nstrain [%],stress [kPa]\n{rows}").into_bytes(),
        format!("LabVIEW Measurement\nSeparator\tTab\nDecimal_Separator\t.\n***End_of_Header***\nX0\t0\nDelta_X\t0.001\nX_Value\tForce [N]\tComment\n{tabs}").into_bytes(),
        format!("X,CH1,Start,Increment\nSequence,Volt,-1e-3,1e-3\n{rows}").into_bytes(),
        format!("Record Length,40,,0.1,0.2\nSample Interval,0.001,,0.2,0.3\nVertical Units,V,,0.3,0.1\n{}", rows.lines().map(|line| format!(",,,{line}\n")).collect::<String>()).into_bytes(),
        [0xfeff_u16].into_iter().chain(format!("t [s];F [N]\n{rows}").encode_utf16()).flat_map(u16::to_le_bytes).collect(),
        "Unit :N\nChannel code :D0ANVL000000FOZP\nSampling interval :1E-3\n1\n2\n3\n4\n5\n".into(),
        xlsx(&[("Sheet1", &[vec!["time [s]", "force [N]"], vec!["0", "1"], vec!["1", "2"]])]),
        ods(&[vec!["time [s]", "force [N]"], vec!["0", "1"], vec!["1", "2"]]),
    ]
}

/// Changes `bytes` as `edits` say: where, what, and how.
fn change(bytes: &mut Vec<u8>, edits: &[(u16, u8, u8)]) {
    for (place, byte, how) in edits {
        let at = usize::from(*place) % bytes.len().max(1);
        match how % 6 {
            0 if !bytes.is_empty() => bytes[at] = *byte,
            1 => bytes.insert(at, *byte),
            2 if !bytes.is_empty() => drop(bytes.remove(at)),
            3 => bytes.truncate(at),
            4 => {
                let end = (at + usize::from(*byte)).min(bytes.len());
                let copy = bytes[at..end].to_vec();
                bytes.splice(at..at, copy);
            }
            _ => {
                let pieces: [&[u8]; 8] = [b"\"", b",,", b"\n\n", b"1e308", b"[", b"-", b"\xff\xfe", b"\t"];
                bytes.splice(at..at, pieces[usize::from(*byte) % 8].iter().copied());
            }
        }
    }
}

#[test]
fn no_bytes_make_the_reader_panic() {
    let cases = std::env::var("SOFTANVIL_CASES").ok().and_then(|text| text.parse().ok()).unwrap_or(600);
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let seeds = seeds();
    let edits = prop::collection::vec((any::<u16>(), any::<u8>(), any::<u8>()), 0..12);
    let result = runner.run(&(0..seeds.len(), edits), |(seed, edits)| {
        let mut bytes = seeds[seed].clone();
        change(&mut bytes, &edits);
        let _ = trace::read("x", &bytes, &Options::default(), Some(&EXPECTED));
        let force = Some("2 [N]".parse().unwrap());
        let _ = trace::read("x", &bytes, &Options { force, rate: Some(1e3), ..Options::default() }, None);
        if let Ok(sheet) = sheet::parse(&bytes, &Layout::default()) {
            let _ = Table::new(sheet, None);
        }
        Ok(())
    });
    if let Err(error) = result {
        panic!("{error}");
    }
}
