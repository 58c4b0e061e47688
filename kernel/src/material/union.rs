//! The coefficients of several laws as one list, in which those of the same name are one. All is done by the compiler.

use crate::material::coefficient::Coefficient;
use crate::number::text::same;

/// How many different names the `lists` have.
pub(super) const fn n_distinct(lists: &[&[Coefficient]]) -> usize {
    let (mut n, mut list) = (0, 0);
    while list < lists.len() {
        let mut i = 0;
        while i < lists[list].len() {
            n += is_first(lists, list, i) as usize;
            i += 1;
        }
        list += 1;
    }
    n
}

/// The first coefficient of each name, of which there have to be `N`.
pub(super) const fn distinct<const N: usize>(lists: &[&[Coefficient]]) -> [Coefficient; N] {
    let mut all = [lists[0][0]; N];
    let (mut n, mut list) = (0, 0);
    while list < lists.len() {
        let mut i = 0;
        while i < lists[list].len() {
            if is_first(lists, list, i) {
                all[n] = lists[list][i];
                n += 1;
            }
            i += 1;
        }
        list += 1;
    }
    all
}

/// Places of the `N` coefficients `own` among the distinct ones of `lists`.
pub(super) const fn places<const N: usize>(own: &[Coefficient], lists: &[&[Coefficient]]) -> [usize; N] {
    let mut places = [0; N];
    let mut k = 0;
    while k < N {
        places[k] = place(own[k].name, lists);
        k += 1;
    }
    places
}

/// How many first ones stand before the first of this name.
const fn place(name: &str, lists: &[&[Coefficient]]) -> usize {
    let (mut n, mut list) = (0, 0);
    while list < lists.len() {
        let mut i = 0;
        while i < lists[list].len() {
            if same(lists[list][i].name, name) {
                return n;
            }
            n += is_first(lists, list, i) as usize;
            i += 1;
        }
        list += 1;
    }
    n
}

/// Whether no list before has a coefficient of this name.
const fn is_first(lists: &[&[Coefficient]], list: usize, index: usize) -> bool {
    let mut before = 0;
    while before < list {
        let mut i = 0;
        while i < lists[before].len() {
            if same(lists[before][i].name, lists[list][index].name) {
                return false;
            }
            i += 1;
        }
        before += 1;
    }
    true
}
