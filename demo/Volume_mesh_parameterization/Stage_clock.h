#ifndef HANDLEBODY_STAGE_CLOCK_H
#define HANDLEBODY_STAGE_CLOCK_H

#include <CGAL/Memory_sizer.h>

#include <ctime>
#include <iostream>
#include <string>
#include <unistd.h>
#include <vector>

// Measures CPU seconds (of all threads) and resident bytes of each stage, and says on a terminal which one runs.
class Stage_clock {
public:
  struct Stage {
    std::string name;
    double seconds;
    std::size_t bytes; // resident in memory at its end
  };

  explicit Stage_clock(bool quiet) : m_shows(!quiet && isatty(STDERR_FILENO)) {}
  ~Stage_clock() { finish(); }

  void start(const std::string& name) {
    finish();
    m_running = name;
    m_start = std::clock();
    if (m_shows) std::cerr << "\r\033[K" << name << " ..." << std::flush;
  }

  void advance(std::size_t done, std::size_t all) const {
    if (m_shows) std::cerr << "\r\033[K" << m_running << " ... " << done << " of " << all << std::flush;
  }

  void finish() {
    if (m_running.empty()) return;
    m_stages.push_back({m_running, double(std::clock() - m_start) / CLOCKS_PER_SEC, CGAL::Memory_sizer().resident_size()});
    m_running.clear();
    if (m_shows) std::cerr << "\r\033[K" << std::flush;
  }

  const std::vector<Stage>& stages() const { return m_stages; }

private:
  bool m_shows;
  std::string m_running;
  std::clock_t m_start = 0;
  std::vector<Stage> m_stages;
};

// Passes the stages of the library on to the clock.
struct Clock_visitor {
  Stage_clock* clock;
  std::string prefix; // of the names
  bool start_stage(const char* name) {
    clock->start(prefix + name);
    return true;
  }
  bool advance(std::size_t done, std::size_t all) {
    clock->advance(done, all);
    return true;
  }
};

#endif // HANDLEBODY_STAGE_CLOCK_H
