"""Failing inputs with the same fault have the same signature, others do not."""

import unittest

from campaign import signature

ASAN = """INFO: Running with entropic power schedule (0xFF, 100).
/fuzzer: Running 1 inputs 1 time(s) each.
Running: crash-1
=================================================================
==41==ERROR: AddressSanitizer: {what} on {address}
READ of size 4 at {address} thread T0
    #0 {address} in __asan_memcpy (/fuzzer+0x1)
    #1 {address} in std::vector<int, std::allocator<int> >::operator[](unsigned long) /usr/include/c++/12/bits/stl_vector.h:1123:9
    #2 {address} in tightflip::kernel::Triangulation::twin(tightflip::kernel::Halfedge) const /s/triangulation.hpp:{line}:9
    #3 {address} in {caller} /s/connect.cpp:3:1
    #4 {address} in tightflip::fuzz::flip_path::objection[abi:cxx11](std::span<unsigned char const, 18446744073709551615ul>) /s/t.cpp:9:5
    #5 {address} in LLVMFuzzerTestOneInput /s/fuzzer_main.cpp:12:5
    #6 {address} in fuzzer::Fuzzer::ExecuteCallback(unsigned char const*, unsigned long) (/fuzzer+0x2)

{address} is located 0 bytes to the right of 4-byte region
allocated by thread T0 here:
    #0 {address} in tightflip::kernel::elsewhere() /s/other.cpp:1:1
"""
CLAIM = """Running: crash-2

three_neighbours: vertex {vertex} has degree {degree}: too few
start: book of 5 vertices

==41== ERROR: libFuzzer: deadly signal
    #0 0x55 in __sanitizer_print_stack_trace (/fuzzer+0x1)
    #1 0x56 in tightflip::fuzz::objection(int) /s/t.cpp:9:5
"""
UNDEFINED = """Running: crash-3
/s/kernel/src/connect.cpp:{line}:24: runtime error: signed integer overflow: {a} + 1 cannot be represented in type 'int'
    #0 0x55 in tightflip::kernel::connect(int) /s/kernel/src/connect.cpp:{line}:24
"""
LEAK = """
=================================================================
==41==ERROR: LeakSanitizer: detected memory leaks

Direct leak of 8 byte(s) in 1 object(s) allocated from:
    #0 0x55 in operator new(unsigned long) (/fuzzer+0x1)
    #1 0x56 in tightflip::kernel::build(int) /s/build.cpp:9:5
"""
NO_SYMBOLS = """==41==ERROR: AddressSanitizer: SEGV on unknown address 0x1 (pc 0x1 bp 0x1 sp 0x1 T0)
    #0 0x55  (/bin/a_fuzzer+0x1234) (BuildId: 12)
    #1 0x56  (/lib/x86_64-linux-gnu/libc.so.6+0x99)
"""


def asan(what="heap-buffer-overflow", address="0x602000000010", line=91,
         caller="tightflip::kernel::connect(int)"):
    return ASAN.format(what=what, address=address, line=line, caller=caller)


class SignatureTest(unittest.TestCase):
    def test_sanitizers_report_by_what_and_where(self):
        self.assertEqual(signature.of("crash", asan()),
                         "heap-buffer-overflow in tightflip::kernel::Triangulation::twin"
                         " < tightflip::kernel::connect < tightflip::fuzz::flip_path::objection")

    def test_addresses_and_lines_do_not_matter(self):
        self.assertEqual(signature.of("crash", asan()),
                         signature.of("crash", asan(address="0x603000000020", line=93)))

    def test_what_and_the_callers_matter(self):
        other = "tightflip::kernel::shorten(int)"
        signatures = {signature.of("crash", text)
                      for text in (asan(), asan(what="heap-use-after-free"), asan(caller=other))}
        self.assertEqual(len(signatures), 3)

    def test_only_the_stack_of_the_failure_counts(self):
        in_a_thread = """==1==ERROR: AddressSanitizer: SEGV on unknown address 0x1
    #0 0x55 in tightflip::kernel::explore(int) /s/explore.cpp:1:1
    #1 0x56 in start_thread (/lib/x86_64-linux-gnu/libc.so.6+0x1)

Thread T1 created by T0 here:
    #0 0x57 in tightflip::fuzz::objection(int) /s/t.cpp:1:1
"""
        self.assertEqual(signature.of("crash", in_a_thread), "SEGV in tightflip::kernel::explore")

    def test_claims_go_by_their_names(self):
        first = signature.of("crash", CLAIM.format(vertex=1, degree=2))
        self.assertEqual(first, "claim: three_neighbours")
        self.assertEqual(first, signature.of("crash", CLAIM.format(vertex=7, degree=1)))

    def test_undefined_behaviour_goes_by_its_place_without_the_numbers(self):
        first = signature.of("crash", UNDEFINED.format(line=9, a=2147483647))
        self.assertEqual(first, "undefined behaviour: signed integer overflow: N + N cannot be "
                                "represented in type 'int' (connect.cpp:9)")
        self.assertNotEqual(first, signature.of("crash", UNDEFINED.format(line=10, a=2147483647)))

    def test_leaks_go_by_who_allocated(self):
        self.assertEqual(signature.of("leak", LEAK), "memory leaks in tightflip::kernel::build")

    def test_timeouts_go_by_the_outermost_frames(self):
        first = asan(caller="tightflip::kernel::connect(int)")
        second = first.replace("kernel::Triangulation::twin(", "kernel::Triangulation::next(")
        self.assertEqual(signature.of("timeout", first), signature.of("timeout", second))
        self.assertEqual(signature.of("timeout", first),
                         "timeout in tightflip::kernel::connect"
                         " < tightflip::fuzz::flip_path::objection")

    def test_without_symbols_what_is_left(self):
        self.assertEqual(signature.of("crash", NO_SYMBOLS), "SEGV in a_fuzzer+0x1234")
        self.assertEqual(signature.of("timeout", ""), "timeout")


if __name__ == "__main__":
    unittest.main()
