"""Plants small faults, one at a time, and sees which test notices."""
