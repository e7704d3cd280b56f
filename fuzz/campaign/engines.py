"""The engines by name. An engine is a module: how to run a target, what a turn left, how to
merge."""

from campaign import engine_afl, engine_libfuzzer

ENGINES = {engine.NAME: engine for engine in (engine_libfuzzer, engine_afl)}
