// Writes what is installed beside the program and follows from its options: the manual page and the
// completions of shells.  The build runs it.
//   wander_pages FOLDER
#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>

#include "records/atomic_file.h"
#include "tools/application.h"
#include "tools/console.h"
#include "tools/packaging/completions.h"
#include "tools/packaging/man_page.h"

int main(int count, char** arguments) {
  using namespace wander;
  try {
    const std::filesystem::path folder = count == 2 ? arguments[1] : ".";
    Global global;
    CLI::App app;
    build_application(app, global);
    std::filesystem::create_directories(folder);
    write_file(folder / "wander.1", packaging::man_page(app));
    write_file(folder / "wander.bash", packaging::bash_completion(app));
    write_file(folder / "_wander", packaging::zsh_completion(app));
    write_file(folder / "wander.fish", packaging::fish_completion(app));
    return 0;
  } catch (const std::exception& problem) {
    print_error(problem.what());
    return 1;
  }
}
