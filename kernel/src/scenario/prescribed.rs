//! The prescribed motion of the face: down from the gap to a depth at a speed, with a smooth start and a smooth stop,
//! then hold. Slow enough it is a quasi-static test, at any speed a ramp-and-hold relaxation test.
//!
//! The velocity rises over `prescribed_rise` as s^2 (3 - 2 s), stays, and falls the same way, so neither end has a jump of
//! velocity or of acceleration to ring the layer. Between the two the speed is exactly `prescribed_speed`, and the whole
//! travel of gap + depth takes travel / speed + rise.

use crate::number::real::Real;
use crate::scenario::Impactor;

/// Height of the face above the undeformed anvil's top, m, `time` s after the start.
pub fn height(impactor: &Impactor, time: Real) -> Real {
    let (speed, travel) = (impactor.prescribed_speed, impactor.gap + impactor.prescribed_depth);
    let rise = rise(impactor);
    let end = travel / speed + rise;
    if time < rise {
        impactor.gap - speed * smooth_start(time, rise)
    } else if time < end - rise {
        impactor.gap - speed * (time - 0.5 * rise)
    } else if time < end {
        -impactor.prescribed_depth + speed * smooth_start(end - time, rise)
    } else {
        -impactor.prescribed_depth
    }
}

/// Upward velocity of the face, m/s, `time` s after the start.
pub fn velocity(impactor: &Impactor, time: Real) -> Real {
    let (rise, end) = (rise(impactor), end(impactor));
    let part = if time < rise {
        time / rise
    } else if time < end - rise {
        1.0
    } else if time < end {
        (end - time) / rise
    } else {
        0.0
    };
    -impactor.prescribed_speed * (part * part * (3.0 - 2.0 * part))
}

/// Time at which the face comes to rest, s.
pub fn end(impactor: &Impactor) -> Real {
    (impactor.gap + impactor.prescribed_depth) / impactor.prescribed_speed + rise(impactor)
}

/// Time over which the speed rises and falls, s: as asked, and at most so long that the speed is reached.
fn rise(impactor: &Impactor) -> Real {
    let longest = (impactor.gap + impactor.prescribed_depth) / impactor.prescribed_speed;
    if impactor.prescribed_rise < longest { impactor.prescribed_rise } else { longest }
}

/// Integral over time of s^2 (3 - 2 s), s = time / rise, from rest, s; `time` is from 0 to `rise`.
fn smooth_start(time: Real, rise: Real) -> Real {
    let s = if rise > 0.0 { time / rise } else { 0.0 };
    rise * (s * s * s) * (1.0 - 0.5 * s)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenario::preset;

    fn impactor(gap: Real, depth: Real, speed: Real, rise: Real) -> Impactor {
        Impactor {
            gap,
            prescribed_depth: depth,
            prescribed_speed: speed,
            prescribed_rise: rise,
            ..preset::study().impactor
        }
    }

    #[test]
    fn starts_at_the_gap_and_holds_at_the_depth() {
        for rise in [0.0, 5e-3, 1e3] {
            let impactor = impactor(2e-3, 5e-3, 0.1, rise);
            assert_eq!(height(&impactor, 0.0), 2e-3);
            for later in [0.0, 1e-9, 1.0, 1e6] {
                assert_eq!(height(&impactor, end(&impactor) + later), -5e-3);
                assert_eq!(velocity(&impactor, end(&impactor) + later), 0.0);
            }
        }
    }

    #[test]
    fn moves_at_the_speed_without_a_jump_and_never_back() {
        for (depth, rise) in [(5e-3, 5e-3), (5e-3, 0.05), (1e-4, 5e-3), (5e-3, 0.0)] {
            let impactor = impactor(0.0, depth, 0.1, rise);
            // A difference of heights rounds as they do: fewer of them in single precision.
            let (n, over, under) = if cfg!(feature = "single") { (1000, 1e-5, 1e-3) } else { (10_000, 1e-9, 1e-6) };
            let dt = end(&impactor) / n as Real;
            let mut fastest: Real = 0.0;
            let slack = 2.0 * Real::EPSILON * 5e-3;
            for k in 0..n {
                let times = [k as Real * dt, (k + 1) as Real * dt];
                let fall = height(&impactor, times[0]) - height(&impactor, times[1]);
                assert!(fall >= -slack && fall <= 0.1 * dt * (1.0 + over) + slack, "{k}: {fall}");
                // The velocity changes by 1.5 of the speed over the rise at most.
                let mean = 0.5 * (velocity(&impactor, times[0]) + velocity(&impactor, times[1]));
                let change = 0.15 * dt / if rise > dt { rise } else { dt };
                assert!((mean * dt + fall).abs() <= change * dt + 2.0 * slack, "{k}: {mean} m/s, {fall} m");
                fastest = crate::number::math::max(fastest, fall);
            }
            assert!(fastest > 0.1 * dt * (1.0 - under));
        }
    }

    #[test]
    fn no_travel_is_rest() {
        let impactor = impactor(0.0, 0.0, 0.1, 5e-3);
        assert_eq!(end(&impactor), 0.0);
        assert_eq!(height(&impactor, 1.0), 0.0);
    }
}
