#ifndef HANDLEBODY_INTERRUPT_H
#define HANDLEBODY_INTERRUPT_H

#include <csignal>

// Ctrl-C asks to stop at the next step; a second one stops at once. In the background of a script it is ignored.
class Interrupt {
public:
  static void watch() {
    if (std::signal(SIGINT, remember) == SIG_IGN) std::signal(SIGINT, SIG_IGN);
  }
  static bool is_requested() { return s_is_requested != 0; }

private:
  static void remember(int) {
    s_is_requested = 1;
    std::signal(SIGINT, SIG_DFL);
  }

  static inline volatile std::sig_atomic_t s_is_requested = 0;
};

#endif // HANDLEBODY_INTERRUPT_H
