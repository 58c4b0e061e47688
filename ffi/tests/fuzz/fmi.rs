//! Sequences of FMI calls, legal or not in the mode that they meet, as a master of either version may make them.

mod fmi2;
mod fmi3;

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ffi::c_void;
use std::ptr::null_mut;
use std::sync::OnceLock;
use std::thread::LocalKey;

use softanvil::variables::{Source, Table, ValueType};

use super::Input;
pub use fmi2::Fmi2;
pub use fmi3::Fmi3;

/// A pointer of the library: an instance, or a saved state.
pub type Pointer = *mut c_void;

/// `fmi2OK` and `fmi3OK`, and the last status of either version.
const OK: i32 = 0;
const FATAL: i32 = 4;

/// What both versions have. Every method is one call of the library and gives its status.
pub trait Standard: Sized {
    /// A new instance; `options` chooses what the version leaves open.
    fn instantiate(options: u8) -> Self;
    fn initialize(&self, start: f64, stop: f64) -> i32;
    fn exit_initialization(&self) -> i32;
    fn set_real(&self, reference: u32, value: f64) -> i32;
    fn set_choice(&self, reference: u32, value: i32) -> i32;
    fn set_boolean(&self, reference: u32, value: bool) -> i32;
    fn reals(&self, references: &[u32], values: &mut [f64]) -> i32;
    fn do_step(&self, point: f64, size: f64) -> i32;
    fn save(&self, state: &mut Pointer) -> i32;
    fn restore(&self, state: Pointer) -> i32;
    fn free_state(&self, state: &mut Pointer) -> i32;
    fn serialize(&self, state: Pointer, bytes: &mut Vec<u8>) -> i32;
    fn deserialize(&self, bytes: &[u8], state: &mut Pointer) -> i32;
    fn terminate(&self) -> i32;
    fn reset(&self) -> i32;
    /// A call that only this version has, or a getter of another type.
    fn other(&self, input: &mut Input) -> i32;
}

/// References of the variables by what a target does with them.
struct References {
    time: u32,
    element_size: u32,
    next_impact: u32,
    /// What a master may set, without what decides how many cells there are: a mesh may be large, and a fuzzer has little time.
    settable: Vec<u32>,
    outputs: Vec<u32>,
}

fn references() -> &'static References {
    static ALL: OnceLock<References> = OnceLock::new();
    ALL.get_or_init(|| {
        let table = Table::new();
        let of = |keep: &dyn Fn(&Source) -> bool| -> Vec<u32> {
            table.rows().iter().filter(|row| keep(&row.source)).map(|row| row.reference).collect()
        };
        let of_size = |source: &Source| match source {
            Source::Parameter(parameter) => {
                let name = parameter.name().to_string();
                ["mesh.", "geometry.", "layers.count", "solid", "time."].iter().any(|part| name.starts_with(part))
                    || ["thickness", "width", "gap"].iter().any(|part| name.ends_with(part))
            }
            _ => false,
        };
        let named = |name: &str| table.rows().iter().find(|row| row.name == name).unwrap().reference;
        References {
            time: of(&|source| matches!(source, Source::Time))[0],
            element_size: named("mesh.element_size"),
            next_impact: named("impact.next"),
            settable: of(&|source| matches!(source, Source::Parameter(_) | Source::Input(_)) && !of_size(source)),
            outputs: table
                .rows()
                .iter()
                .filter(|row| matches!(row.source, Source::Output(_) | Source::KernelTime))
                .filter(|row| matches!(row.value, ValueType::Real { .. }))
                .map(|row| row.reference)
                .collect(),
        }
    })
}

/// A saved state, and what the outputs were then.
struct Saved {
    state: Pointer,
    outputs: Option<Vec<u64>>,
}

/// An instance with what its master keeps.
struct Master<S: Standard> {
    instance: S,
    saved: Vec<Saved>,
    bytes: Vec<u8>,
}

impl<S: Standard> Master<S> {
    /// Bits of all outputs; none where they cannot be read.
    fn outputs(&self) -> Option<Vec<u64>> {
        let references = &references().outputs;
        let mut values = vec![0.0; references.len()];
        (self.instance.reals(references, &mut values) == OK).then(|| values.iter().map(|v: &f64| v.to_bits()).collect())
    }

    fn time(&self) -> Option<f64> {
        let mut time = [0.0];
        (self.instance.reals(&[references().time], &mut time) == OK).then_some(time[0])
    }

    /// A step that was made leads to numbers; one that was refused changes none.
    fn do_step(&self, input: &mut Input) {
        let (before, now) = (self.outputs(), self.time().unwrap_or(0.0));
        let point = if input.byte().is_multiple_of(8) { input.number() } else { now };
        let size = match input.byte() % 4 {
            0 => input.number().min(2e-4),
            1 => f64::from(input.word()) * 1e-9,
            _ => f64::from(input.byte()) * 1e-6,
        };
        let status = self.instance.do_step(point, size);
        let after = self.outputs();
        if status == OK {
            let values = after.expect("outputs of a step that was made");
            assert!(values.iter().all(|bits| f64::from_bits(*bits).is_finite()), "an output is no number after a step");
        } else if self.time() == Some(now) && point != now {
            assert_eq!(before, after, "a step that was refused has changed an output");
        }
    }

    fn save(&mut self) {
        let mut state = null_mut();
        let outputs = self.outputs();
        if self.instance.save(&mut state) == OK && self.saved.len() < 4 {
            self.saved.push(Saved { state, outputs });
        } else {
            self.instance.free_state(&mut state);
        }
    }

    /// Outputs are those of the time at which the state was saved.
    fn restore(&self, which: u8) {
        let Some(saved) = self.saved.get(usize::from(which) % self.saved.len().max(1)) else {
            self.instance.restore(null_mut());
            return;
        };
        if self.instance.restore(saved.state) == OK && saved.outputs.is_some() {
            assert_eq!(self.outputs(), saved.outputs, "a state that was restored has other outputs");
        }
    }

    /// Bytes as they are, or some of them others: a state, or refused.
    fn deserialize(&mut self, input: &mut Input) {
        let change = input.byte() % 4;
        if !self.bytes.is_empty() {
            for _ in 0..change {
                let at = usize::from(input.word()) * 8 % self.bytes.len();
                let end = (at + 8).min(self.bytes.len());
                self.bytes[at..end].copy_from_slice(&input.number().to_le_bytes()[..end - at]);
            }
            if input.byte().is_multiple_of(2) && self.bytes.len().is_multiple_of(8) {
                super::seal(&mut self.bytes);
            }
        }
        let mut state = null_mut();
        if self.instance.deserialize(&self.bytes, &mut state) == OK && self.saved.len() < 4 {
            self.saved.push(Saved { state, outputs: None });
        } else {
            self.instance.free_state(&mut state);
        }
    }

    fn call(&mut self, input: &mut Input) {
        let all = references();
        let settable = all.settable[usize::from(input.word()) % all.settable.len()];
        let status = match input.byte() % 16 {
            0 => self.instance.initialize(input.number(), input.number()),
            1 => self.instance.initialize(0.0, 1.0),
            2 => self.instance.exit_initialization(),
            3..=5 => self.instance.set_real(settable, input.number()),
            6 => self.instance.set_choice(settable, i32::from(input.byte() as i8)),
            7 if input.byte().is_multiple_of(2) => {
                self.instance.set_boolean(all.next_impact, input.byte().is_multiple_of(2))
            }
            7 => self.instance.set_real(u32::from(input.word()), input.number()),
            8 if input.byte().is_multiple_of(4) => self.instance.terminate(),
            9 if input.byte().is_multiple_of(4) => {
                let status = self.instance.reset();
                self.instance.set_real(all.element_size, 7e-3);
                status
            }
            10 => {
                self.save();
                OK
            }
            11 => {
                self.restore(input.byte());
                OK
            }
            12 => match self.saved.last() {
                Some(saved) => self.instance.serialize(saved.state, &mut self.bytes),
                None => self.instance.serialize(null_mut(), &mut self.bytes),
            },
            13 => {
                self.deserialize(input);
                OK
            }
            14 => self.instance.other(input),
            _ => {
                self.do_step(input);
                OK
            }
        };
        assert!((OK..FATAL).contains(&status), "status {status}");
    }

    /// The instance, without what its master has kept.
    fn give_back(mut self) -> S {
        for saved in &mut self.saved {
            self.instance.free_state(&mut saved.state);
        }
        self.instance
    }
}

/// Instances by their options: they are used again, because an instance that is reset keeps its model, and building one takes
/// a hundred times as long as what an input asks for.
type Instances<S> = LocalKey<RefCell<BTreeMap<u8, S>>>;

/// The bytes of an instance in its initial state.
fn initial<S: Standard>(instance: &S) -> Vec<u8> {
    let (mut state, mut bytes) = (null_mut(), Vec::new());
    assert_eq!(instance.set_real(references().element_size, 7e-3), OK);
    assert_eq!([instance.initialize(0.0, 1.0), instance.exit_initialization(), instance.save(&mut state)], [OK; 3]);
    assert_eq!([instance.serialize(state, &mut bytes), instance.free_state(&mut state)], [OK; 2]);
    bytes
}

fn sequence<S: Standard>(data: &[u8], instances: &'static Instances<S>, initialized: &OnceLock<Vec<u8>>) {
    let mut input = Input(data);
    let options = input.byte();
    let used = instances.with_borrow_mut(|all| all.remove(&(options >> 4)));
    let instance = used.unwrap_or_else(|| S::instantiate(options));
    assert_eq!(instance.reset(), OK);
    let mut master = Master { instance, saved: Vec::new(), bytes: Vec::new() };
    if options % 8 == 0 {
        master.instance.set_real(references().element_size, 7e-3);
    } else {
        let bytes = initialized.get_or_init(|| initial(&S::instantiate(0)));
        let mut state = null_mut();
        assert_eq!(master.instance.deserialize(bytes, &mut state), OK);
        assert_eq!([master.instance.restore(state), master.instance.free_state(&mut state)], [OK; 2]);
    }
    while !input.0.is_empty() {
        master.call(&mut input);
    }
    let instance = master.give_back();
    instances.with_borrow_mut(|all| all.insert(options >> 4, instance));
}

/// A master of FMI 2.0.
pub fn fmi2(data: &[u8]) {
    thread_local!(static INSTANCES: RefCell<BTreeMap<u8, Fmi2>> = const { RefCell::new(BTreeMap::new()) });
    static INITIALIZED: OnceLock<Vec<u8>> = OnceLock::new();
    sequence::<Fmi2>(data, &INSTANCES, &INITIALIZED);
}

/// A master of FMI 3.0.
pub fn fmi3(data: &[u8]) {
    thread_local!(static INSTANCES: RefCell<BTreeMap<u8, Fmi3>> = const { RefCell::new(BTreeMap::new()) });
    static INITIALIZED: OnceLock<Vec<u8>> = OnceLock::new();
    sequence::<Fmi3>(data, &INSTANCES, &INITIALIZED);
}
