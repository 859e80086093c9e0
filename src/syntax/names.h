// The names of a scene: global ones and those of files and macros, the innermost of which is seen first.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "syntax/value.h"

namespace rt {

struct NameHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const { return std::hash<std::string_view>{}(name); }
};
/// What is looked up by its name, without a string of its own for it.
template <typename T>
using ByName = std::unordered_map<std::string, T, NameHash, std::equal_to<>>;

/// Scope 0 is the whole scene. Each file that is included and each macro that is called opens one more, which ends with it. As in POV-Ray a
/// name is looked for in every open scope, so a macro sees the local names of whoever calls it.
class Names {
public:
    /// The innermost variable of that name, null if there is none.
    const VariablePtr& find(std::string_view name) const;
    /// The same as seen from `scope`: what was opened inside it is left out.
    const VariablePtr& find_from(std::size_t scope, std::string_view name) const;
    /// The variable of just this scope.
    const VariablePtr& find_in(std::size_t scope, std::string_view name) const;

    /// Makes `name` stand for `variable` in `scope`, which is open.
    void bind(std::size_t scope, std::string_view name, VariablePtr variable);
    /// Removes the innermost variable of that name; false if there is none.
    bool unbind(std::string_view name);

    void open_scope();
    void close_scope();
    std::size_t depth() const { return depth_; }  ///< the innermost scope

private:
    struct Binding {
        std::size_t scope;
        VariablePtr variable;
    };
    using Bindings = std::vector<Binding>;  ///< of one name, outermost first

    ByName<Bindings> table_;
    std::vector<std::vector<Bindings*>> bound_;  ///< by scope, from 1; those that are closed keep their memory
    std::size_t depth_ = 0;
};

}  // namespace rt
