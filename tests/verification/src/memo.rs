//! Results that the tests and the table share within one program, each computed once.

use std::sync::{Arc, Mutex, OnceLock};

/// A result that any thread may compute, the others wait for.
type Slot<V> = Arc<OnceLock<V>>;

/// Results by key.
pub struct Memo<K, V>(Mutex<Vec<(K, Slot<V>)>>);

impl<K: PartialEq, V: Clone> Memo<K, V> {
    /// Nothing computed.
    pub const fn new() -> Self {
        Self(Mutex::new(Vec::new()))
    }

    /// The result of `key`, by `compute` if there is none yet.
    ///
    /// # Panics
    /// If the thread that computed one has panicked.
    pub fn get(&self, key: K, compute: impl FnOnce() -> V) -> V {
        let slot = {
            let mut slots = self.0.lock().expect("no panic while the list is held");
            match slots.iter().find(|(known, _)| *known == key) {
                Some((_, slot)) => slot.clone(),
                None => {
                    let slot = Slot::default();
                    slots.push((key, slot.clone()));
                    slot
                }
            }
        };
        slot.get_or_init(compute).clone()
    }
}

impl<K: PartialEq, V: Clone> Default for Memo<K, V> {
    fn default() -> Self {
        Self::new()
    }
}
