# Written by stubs.py from the kernel's table of outputs.
OUTPUTS: dict[str, tuple[str, str]]

class Numbers:
    outputs: dict[str, float]
    @property
    def peak_force(self) -> float:
        """largest contact force so far (of contact.force), N"""
    @property
    def max_deformation(self) -> float:
        """largest deformation so far, m"""
    @property
    def impact_duration(self) -> float:
        """time covered by contact.force at or above measurement.force_threshold, s"""
    @property
    def impulse(self) -> float:
        """impulse of the contact force so far, N.s"""
    @property
    def impact_speed(self) -> float:
        """downward speed before the first contact, m/s"""
    @property
    def rebound_speed(self) -> float:
        """upward speed after the last contact so far; negative while the impactor still falls, m/s"""
    @property
    def restitution(self) -> float:
        """rebound speed over impact speed"""
    @property
    def contact_time(self) -> float:
        """time from the first to the last contact so far, s"""
