#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace frond {

/// A function that is called while its caller waits: it refers to what it was made of and keeps nothing.
template <class Signature>
class FunctionRef;

template <class Return, class... Arguments>
class FunctionRef<Return(Arguments...)> {
 public:
  template <class F>
  requires(!std::is_same_v<std::remove_cvref_t<F>, FunctionRef>) FunctionRef(F&& function)
      : function_(const_cast<void*>(static_cast<const void*>(std::addressof(function)))),
        call_([](void* f, Arguments... arguments) -> Return {
          return (*static_cast<std::remove_reference_t<F>*>(f))(std::forward<Arguments>(arguments)...);
        }) {}

  Return operator()(Arguments... arguments) const {
    return call_(function_, std::forward<Arguments>(arguments)...);
  }

 private:
  void* function_;
  Return (*call_)(void*, Arguments...);
};

}  // namespace frond
