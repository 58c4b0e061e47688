//! Memory on pages of its own. Besides lines that two cores write, what they fetch ahead of need may slow both down, which
//! ends with a page.

use std::marker::PhantomData;

#[derive(Clone, Copy, Default)]
#[repr(align(4096))]
struct Page {
    _numbers: [[u64; 32]; 16],
}

/// Items of one kind, side by side from the start of a page.
pub struct Pages<T> {
    memory: Vec<Page>,
    n: usize,
    of: PhantomData<T>,
}

impl<T: Copy> Pages<T> {
    /// `n` copies of `value`.
    ///
    /// # Panics
    /// If `T` needs a wider alignment than a page has.
    pub fn new(value: T, n: usize) -> Self {
        assert!(align_of::<T>() <= align_of::<Page>());
        let memory = vec![Page::default(); (n * size_of::<T>()).div_ceil(size_of::<Page>())];
        let mut pages = Self { memory, n, of: PhantomData };
        let start = pages.memory.as_mut_ptr().cast::<T>();
        for index in 0..n {
            // SAFETY: within the memory, which is aligned for `T`.
            unsafe { start.add(index).write(value) };
        }
        pages
    }

    /// All items.
    pub fn items(&mut self) -> &mut [T] {
        // SAFETY: `new` has filled the memory with this many.
        unsafe { std::slice::from_raw_parts_mut(self.memory.as_mut_ptr().cast(), self.n) }
    }
}
