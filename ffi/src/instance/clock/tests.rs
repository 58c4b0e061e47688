//! Every number is a sum of powers of two, or differs from one by what is or is not rounding.

use super::*;

const DT: f64 = 0.5;
const CLOCK: Clock = Clock { point: 1.0, ahead: 0.125 };

#[test]
fn rounding_is_relative_to_the_larger_time() {
    let clock = |point| Clock::at(point);
    assert_eq!(clock(8.0).rounding(-2.0), 32.0 * f64::EPSILON);
    assert_eq!(clock(-2.0).rounding(8.0), 32.0 * f64::EPSILON);
    assert_eq!(clock(0.0).rounding(0.0), 0.0);
}

#[test]
fn the_kernels_time_is_its_own_count_unless_the_master_counts_otherwise() {
    let clock = Clock { point: 1.5, ahead: 0.25 };
    assert_eq!(clock.kernel_time(DT, 1.25 + 4e-10), 1.25 + 4e-10);
    assert_eq!(clock.kernel_time(DT, 1.25 + 7e-10), 1.25);
    assert_eq!(clock.kernel_time(DT, 3.0), 1.25);
}

#[test]
fn rounding_moves_the_point_and_not_how_far_it_is_ahead() {
    for moved in [0.0, 4e-10, -4e-10] {
        let clock = CLOCK.follow(1.0 + moved, 0.0, DT).unwrap();
        assert_eq!(clock, Clock { point: 1.0 + moved, ahead: 0.125 });
    }
    // Of an experiment that starts late more is rounding.
    assert_eq!(CLOCK.follow(1.0 + 5e-7, 1e9, DT).unwrap().ahead, 0.125);
}

#[test]
fn a_point_up_to_half_a_step_away_is_followed() {
    for moved in [6e-10, 0.125, 0.25, -0.25] {
        let clock = CLOCK.follow(1.0 + moved, 0.0, DT).unwrap();
        assert_eq!(clock.point, 1.0 + moved);
        assert!((clock.ahead - (0.125 + moved)).abs() < 1e-15, "{moved}");
        assert_ne!(clock.ahead, 0.125);
    }
    for moved in [0.25 + 1e-12, -0.25 - 1e-12, 0.4, f64::NAN] {
        let error = CLOCK.follow(1.0 + moved, 0.0, DT).unwrap_err();
        let Error::CommunicationPoint { given, expected, half } = error else { panic!("{error}") };
        assert!(given == 1.0 + moved || moved.is_nan());
        assert_eq!([expected, half], [1.0, 0.25]);
    }
}

#[test]
fn the_point_is_at_most_a_step_behind_the_kernel() {
    let behind = Clock { point: 1.0, ahead: -0.375 };
    assert_eq!(behind.follow(0.875, 0.0, DT), Ok(Clock { point: 0.875, ahead: -0.5 }));
    assert!(behind.follow(0.75, 0.0, DT).is_err());
}

#[test]
fn a_step_makes_the_kernel_steps_to_the_nearest() {
    let steps = |ahead, step| Clock { point: 7.0, ahead }.steps_in(step, DT);
    assert_eq!([steps(0.125, 1.0), steps(0.25, 1.0), steps(-0.25, 1.0), steps(-0.375, 0.5)], [2, 3, 2, 0]);
}

#[test]
fn the_end_of_a_step_is_a_whole_number_of_steps_away_but_for_rounding() {
    let until_end = |ahead, count| Clock { point: 7.0, ahead }.steps_until_end(1.0, count, DT);
    assert_eq!(until_end(0.25, 3), 2.5);
    assert_eq!(until_end(-0.25, 2), 1.5);
    assert_eq!(until_end(4e-10, 2), 2.0);
    assert!((until_end(2e-9, 2) - 2.000_000_004).abs() < 1e-14);
}

#[test]
fn the_kernels_time_after_some_steps_is_told_from_the_point() {
    assert_eq!(CLOCK.until(3, DT), 1.375);
    assert_eq!(Clock { point: 7.0, ahead: -0.125 }.until(1, DT), 0.625);
    assert_eq!(Clock { point: 7.0, ahead: 4e-10 }.until(3, DT), 1.5);
    assert_eq!(Clock { point: 7.0, ahead: 7e-10 }.until(3, DT), 1.5 - 7e-10);
}

#[test]
fn a_complete_step_leads_to_its_end() {
    let complete = |point, ahead, step, count| Clock { point, ahead }.complete(step, count, DT, 9.0);
    assert_eq!(complete(2.0, 0.125, 1.0, 2), Clock { point: 3.0, ahead: 0.125 });
    assert_eq!(complete(2.0, 0.25, 1.0, 3), Clock { point: 3.0, ahead: -0.25 });
    assert_eq!(complete(2.0, 0.0, 1.0, 2), Clock { point: 3.0, ahead: 0.0 });
}

#[test]
fn what_is_left_at_the_end_of_a_step_is_rounding_relative_to_the_shorter_of_the_two_steps() {
    let left = |step: f64, count: i64, ahead: f64| {
        let before = count as f64 * DT - step + ahead;
        Clock { point: 2.0, ahead: before }.complete(step, count, DT, 9.0).ahead
    };
    // The kernel's, 0.5 s.
    assert_eq!(left(1.0, 2, 4e-10), 0.0);
    assert!((left(1.0, 2, 8e-10) - 8e-10).abs() < 1e-16);
    // The master's, 0.125 s.
    assert_eq!(left(0.125, 0, 1e-10), 0.0);
    assert!((left(0.125, 0, 2e-10) - 2e-10).abs() < 1e-16);
}

#[test]
fn on_a_kernel_step_the_time_is_the_kernels() {
    let rounded = 3.0 + 4e-10;
    assert_eq!(Clock::at(2.0).complete(1.0, 2, DT, rounded), Clock::at(rounded));
    assert_eq!(CLOCK.interrupted(2, DT, 1.875 + 4e-10), Clock::at(1.875 + 4e-10));
    assert_eq!(CLOCK.interrupted(2, DT, 9.0), Clock::at(1.875));
    // Before the first of them it is where it was.
    assert_eq!(CLOCK.interrupted(0, DT, 0.875), CLOCK);
}
