// Runs one command and turns an exception into a message and an exit status.
#include <fmt/format.h>

#include <exception>
#include <new>
#include <string_view>

#include "commands/base/interrupt.h"
#include "commands/base/program.h"
#include "commands/commands.h"
#include "core/source.h"

namespace {

constexpr int exit_mistake = 1;  // in the scene or on the command line
constexpr int exit_not_written = 3;
constexpr int exit_limit = 4;
constexpr int exit_internal = 5;

int report(int status, const char* what, const char* before = "raytrace: ") {
    rt::write_stderr(fmt::format("{}{}\n", before, what));
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    rt::open_standard_streams();
    rt::install_signal_handlers();
    try {
        return rt::run_program(rt::Words(argv + 1, argv + argc));
    } catch (const rt::SceneError& error) {
        return report(exit_mistake, error.what(), "");  // begins with POV-Ray's line, which editors parse
    } catch (const rt::OptionError& error) {
        return report(exit_mistake, error.what());
    } catch (const rt::OutputError& error) {
        return report(exit_not_written, error.what());
    } catch (const rt::LimitError& error) {
        const bool placed = std::string_view(error.what()).starts_with("File '");  // likewise
        return report(exit_limit, error.what(), placed ? "" : "raytrace: ");
    } catch (const std::bad_alloc&) {
        return report(exit_limit, "out of memory");
    } catch (const std::exception& error) {
        return report(exit_internal, error.what(), "raytrace: internal fault: ");
    }
}
