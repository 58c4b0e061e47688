//! What the page calls. Addresses and lengths are bytes in the memory that it shares with the module.

use std::cell::RefCell;

use crate::request::Session;

/// What lies between two calls.
#[derive(Default)]
struct Exchange {
    request: Vec<u8>,
    file: Vec<u8>,
    answer: Vec<u8>,
    session: Session,
}

thread_local! {
    static EXCHANGE: RefCell<Exchange> = RefCell::default();
}

/// Makes room for a request of so many bytes; returns its address.
// The name has to be the linker's; nothing else is called so.
#[unsafe(no_mangle)]
pub extern "C" fn softanvil_request(length: usize) -> *mut u8 {
    EXCHANGE.with_borrow_mut(|exchange| {
        exchange.request = vec![0; length];
        exchange.request.as_mut_ptr()
    })
}

/// Makes room for a file of so many bytes that belongs to the request; returns its address.
// As above.
#[unsafe(no_mangle)]
pub extern "C" fn softanvil_file(length: usize) -> *mut u8 {
    EXCHANGE.with_borrow_mut(|exchange| {
        exchange.file = vec![0; length];
        exchange.file.as_mut_ptr()
    })
}

/// Answers the request; returns the length of the answer.
// As above.
#[unsafe(no_mangle)]
pub extern "C" fn softanvil_answer() -> usize {
    EXCHANGE.with_borrow_mut(|exchange| {
        let Exchange { request, file, answer, session } = exchange;
        *answer = session.answer(request, file).into_bytes();
        file.clear();
        answer.len()
    })
}

/// The address of the answer.
// As above.
#[unsafe(no_mangle)]
pub extern "C" fn softanvil_answer_address() -> *const u8 {
    EXCHANGE.with_borrow(|exchange| exchange.answer.as_ptr())
}
