// Links the properties core: a small campaign of random flips under audit on a surface of genus 2.
#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/campaign.hpp>

#include <iostream>

int main() {
    const auto start = tightflip::kernel::families::surface_of_genus(2, 100, 7);
    const auto report = tightflip::properties::run_campaign(start, {.flips = 100'000, .seed = 7});
    std::cout << report.done << " flips done, " << report.audits << " audits, "
              << (report.failure ? "violated" : "no violation") << '\n';
    return report.failure ? 1 : 0;
}
