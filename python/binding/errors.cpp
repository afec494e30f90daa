#include "python/binding/errors.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <string>

#include "lab/failure.h"
#include "mlt/seeds/nothing_found.h"
#include "records/atomic_file.h"
#include "records/run_record.h"
#include "scenes/format/scene_file.h"
#include "scenes/import/import_fault.h"
#include "tools/examination.h"

namespace wander::python {

namespace nb = nanobind;

namespace {

std::string errors_module;  // of the package that this module is in

nb::object made(const char* name, const std::string& message) {
  return nb::module_::import_(errors_module.c_str()).attr(name)(message);
}

void raise(const nb::object& error) { PyErr_SetObject(error.type().ptr(), error.ptr()); }

// Each with the place where it is: (line, column, pointer, what).
template <class Fault>
nb::list places_of(const std::vector<Fault>& faults) {
  nb::list places;
  for (const Fault& fault : faults)
    if constexpr (requires { fault.pointer; })
      places.append(nb::make_tuple(fault.line, fault.column, fault.pointer, fault.what));
    else
      places.append(nb::make_tuple(fault.line, fault.column, fault.path, fault.what));
  return places;
}

template <class Error>
void raise_with_places(const char* name, const Error& error) {
  nb::object object = made(name, error.what());
  object.attr("faults") = places_of(error.faults);
  raise(object);
}

// Several at once are told as the first, with the messages of all.
std::string messages_of(const Failures& failures) {
  std::string all;
  for (const std::exception_ptr& one : failures.found) try {
      std::rethrow_exception(one);
    } catch (const std::exception& error) {
      all += (all.empty() ? "" : "\n") + std::string(error.what());
    }
  return all;
}

const char* class_of(ExitCode code) {
  switch (code) {
    case ExitCode::usage:
      return "UsageError";
    case ExitCode::invalid_input:
      return "FileError";
    default:
      return "RunError";
  }
}

void translate(const std::exception_ptr& problem, void*) {
  try {
    std::rethrow_exception(problem);
  } catch (const Failures& failures) {
    if (failures.found.size() == 1)
      translate(failures.found.front(), nullptr);
    else
      raise(made("UsageError", messages_of(failures)));
  } catch (const SceneFileError& error) {
    raise_with_places("SceneError", error);
  } catch (const ImportError& error) {
    raise_with_places("SceneError", error);
  } catch (const NoLightFound& error) {
    raise(made("NoLightFound", error.what()));
  } catch (const CommandFailure& error) {
    raise(made(class_of(error.code()), error.what()));
  } catch (const RunFileError& error) {
    raise(made("FileError", error.what()));
  } catch (const OutputError& error) {
    raise(made("OutputError", error.what()));
  }
}

}  // namespace

void translate_errors(const nb::module_& module) {
  const auto name = nb::cast<std::string>(module.attr("__name__"));
  errors_module = name.substr(0, name.rfind('.') + 1) + "errors";
  nb::register_exception_translator(translate);
}

}  // namespace wander::python
