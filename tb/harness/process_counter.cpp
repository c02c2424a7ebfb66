// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/process_counter.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string_view>
#include <systemc>
#include <utility>
#include <vector>

namespace blysk::harness {
namespace {

/// Calls look() at the end of each update phase. SystemC 3 has a callback for it; before, files of waves are what is called
/// then.
#if IEEE_1666_SYSTEMC >= 202301L
class after_updates : public sc_core::sc_stage_callback_if {
 protected:
  after_updates() { sc_core::sc_register_stage_callback(*this, sc_core::SC_POST_UPDATE); }
  ~after_updates() override { sc_core::sc_unregister_stage_callback(*this, sc_core::SC_POST_UPDATE); }
  virtual void look() = 0;

 private:
  void stage_callback(const sc_core::sc_stage&) override { look(); }
};
#else
class after_updates : public sc_core::sc_trace_file {
 protected:
  after_updates() { sc_core::sc_get_curr_simcontext()->add_trace_file(this); }
  ~after_updates() override { sc_core::sc_get_curr_simcontext()->remove_trace_file(this); }
  virtual void look() = 0;

 private:
  void cycle(bool is_delta) override {
    if (is_delta) look();
  }

  // Nothing is traced.
  using text = std::string;
  void trace(const sc_core::sc_event&, const text&) override {}
  void trace(const sc_core::sc_time&, const text&) override {}
  void trace(const bool&, const text&) override {}
  void trace(const sc_dt::sc_bit&, const text&) override {}
  void trace(const sc_dt::sc_logic&, const text&) override {}
  void trace(const unsigned char&, const text&, int) override {}
  void trace(const unsigned short&, const text&, int) override {}
  void trace(const unsigned int&, const text&, int) override {}
  void trace(const unsigned long&, const text&, int) override {}
  void trace(const char&, const text&, int) override {}
  void trace(const short&, const text&, int) override {}
  void trace(const int&, const text&, int) override {}
  void trace(const long&, const text&, int) override {}
  void trace(const sc_dt::int64&, const text&, int) override {}
  void trace(const sc_dt::uint64&, const text&, int) override {}
  void trace(const float&, const text&) override {}
  void trace(const double&, const text&) override {}
  void trace(const sc_dt::sc_int_base&, const text&) override {}
  void trace(const sc_dt::sc_uint_base&, const text&) override {}
  void trace(const sc_dt::sc_signed&, const text&) override {}
  void trace(const sc_dt::sc_unsigned&, const text&) override {}
  void trace(const sc_dt::sc_fxval&, const text&) override {}
  void trace(const sc_dt::sc_fxval_fast&, const text&) override {}
  void trace(const sc_dt::sc_fxnum&, const text&) override {}
  void trace(const sc_dt::sc_fxnum_fast&, const text&) override {}
  void trace(const sc_dt::sc_bv_base&, const text&) override {}
  void trace(const sc_dt::sc_lv_base&, const text&) override {}
  void trace(const unsigned int&, const text&, const char**) override {}
  void write_comment(const text&) override {}
  void set_time_unit(double, sc_core::sc_time_unit) override {}
};
#endif

/// What a method is sensitive to. The kernel keeps it from all but its own classes; it is known once ports are bound.
struct any_process : sc_core::sc_process_b {
  static const std::vector<const sc_core::sc_event*>& sensitivity(const sc_core::sc_process_b& of) {
    return of.*(&any_process::m_static_events);
  }
};

using numbers = std::vector<std::size_t>;

/// A signal and the processes that its changes run.
class watched {
 public:
  explicit watched(const sc_core::sc_event& on_change) : on_change_(&on_change) {}
  virtual ~watched() = default;
  watched(const watched&) = delete;
  watched& operator=(const watched&) = delete;

  /// Whether it has another value than at the last call.
  virtual bool has_changed() = 0;

  /// What a change to the present value runs.
  virtual const numbers& edge() const = 0;

  const numbers& change() const { return change_; }

  /// \return  whether the event is one of the signal's
  virtual bool add(const sc_core::sc_event& event, std::size_t process) {
    if (&event != on_change_) return false;
    change_.push_back(process);
    return true;
  }

  virtual bool runs_anything() const { return !change_.empty(); }

 private:
  const sc_core::sc_event* on_change_;
  numbers change_;
};

template <class T>
class watched_signal : public watched {
 public:
  explicit watched_signal(const sc_core::sc_signal_in_if<T>& of)
      : watched(of.value_changed_event()), of_(of), last_(of.read()) {}

  bool has_changed() override {
    const T& now = of_.read();
    if (now == last_) return false;
    last_ = now;
    return true;
  }
  const numbers& edge() const override {
    static const numbers kNone;
    return kNone;
  }

 protected:
  const T& last() const { return last_; }

 private:
  const sc_core::sc_signal_in_if<T>& of_;
  T last_;
};

class watched_bit final : public watched_signal<bool> {
 public:
  explicit watched_bit(const sc_core::sc_signal_in_if<bool>& of)
      : watched_signal<bool>(of), on_rise_(&of.posedge_event()), on_fall_(&of.negedge_event()) {}

  const numbers& edge() const override { return last() ? rise_ : fall_; }
  bool add(const sc_core::sc_event& event, std::size_t process) override {
    if (watched::add(event, process)) return true;
    if (&event != on_rise_ && &event != on_fall_) return false;
    add_to_edge(&event == on_rise_, process);
    return true;
  }
  void add_to_edge(bool rises, std::size_t process) { (rises ? rise_ : fall_).push_back(process); }
  bool runs_anything() const override { return watched::runs_anything() || !rise_.empty() || !fall_.empty(); }

 private:
  const sc_core::sc_event* on_rise_;
  const sc_core::sc_event* on_fall_;
  numbers rise_, fall_;
};

template <class T>
std::unique_ptr<watched> watch_if(const sc_core::sc_object& object) {
  const auto* const of = dynamic_cast<const sc_core::sc_signal_in_if<T>*>(&object);
  return of == nullptr ? nullptr : std::make_unique<watched_signal<T>>(*of);
}

template <std::size_t... Widths>
std::unique_ptr<watched> watch_number(const sc_core::sc_object& object, std::index_sequence<Widths...>) {
  std::unique_ptr<watched> made;
  const bool is_known = (... || ((made = watch_if<sc_dt::sc_uint<Widths + 1>>(object)) ||
                                 (made = watch_if<sc_dt::sc_int<Widths + 1>>(object))));
  return is_known ? std::move(made) : nullptr;
}

void list_objects(const std::vector<sc_core::sc_object*>& of, std::vector<sc_core::sc_object*>& to) {
  for (sc_core::sc_object* each : of) {
    to.push_back(each);
    list_objects(each->get_child_objects(), to);
  }
}

/// One address for a signal and for what ports know of it.
template <class Part>
const void* whole(const Part* part) {
  return dynamic_cast<const void*>(part);
}

}  // namespace

class process_counter::watch final : public sc_core::sc_prim_channel, private after_updates {
 public:
  watch() : sc_core::sc_prim_channel(sc_core::sc_gen_unique_name("process_counter")) {}

  std::uint64_t runs() const {
    std::uint64_t sum = 0;
    for (const auto& each : processes_) sum += each.runs;
    return sum;
  }
  std::uint64_t runs(const std::string& name) const {
    const auto found = std::ranges::find(processes_, name, &process::name);
    if (found == processes_.end()) throw std::out_of_range("no process " + name);
    return found->runs;
  }
  void look_at_all() { looks_at_all_ = true; }

 private:
  static constexpr std::size_t kOutside = ~std::size_t{0};
  struct process {
    std::string name;
    std::size_t module;      // of modules_
    std::uint64_t runs = 0;  // and one that is to come after an update phase
    std::uint64_t last_look = 0;
  };

  void start_of_simulation() override {
    std::vector<sc_core::sc_object*> objects;
    list_objects(sc_core::sc_get_top_level_objects(), objects);
    std::map<const void*, std::size_t> place;
    std::map<std::string, watched_bit*> clocks;
    for (const sc_core::sc_object* each : objects) {
      std::unique_ptr<watched> made;
      if (const auto* const bit = dynamic_cast<const sc_core::sc_signal_in_if<bool>*>(each)) {
        auto watched = std::make_unique<watched_bit>(*bit);
        if (dynamic_cast<const sc_core::sc_clock*>(each) != nullptr) clocks[each->basename()] = watched.get();
        made = std::move(watched);
      } else {
        made = watch_number(*each, std::make_index_sequence<64>{});
      }
      if (!made) continue;
      place[whole(each)] = signals_.size();
      signals_.push_back(std::move(made));
    }
    for (const sc_core::sc_object* each : objects) {
      if (const auto* const one = dynamic_cast<const sc_core::sc_process_b*>(each)) add(*one, clocks);
    }
    find_drivers(objects, place);
    ran_.resize(modules_.size(), false);
  }

  void add(const sc_core::sc_process_b& one, const std::map<std::string, watched_bit*>& clocks) {
    if (std::string_view(one.kind()) != "sc_method_process")
      throw std::logic_error(std::string(one.name()) + " is no method, and its runs are not counted");
    const std::size_t number = processes_.size();
    const sc_core::sc_object* const parent = one.get_parent_object();
    std::size_t module = kOutside;
    if (parent != nullptr) {
      module = static_cast<std::size_t>(std::ranges::find(modules_, parent) - modules_.begin());
      if (module == modules_.size()) modules_.push_back(parent);
    }
    processes_.push_back({one.name(), module, one.dont_initialize() ? 0U : 1U});
    for (const sc_core::sc_event* event : any_process::sensitivity(one)) {
      bool is_known = false;
      for (const auto& signal : signals_) is_known = is_known || signal->add(*event, number);
      if (!is_known && !is_of_clock(one, number, clocks))
        throw std::logic_error(std::string(one.name()) +
                               " waits for what is no change of a signal, and its runs are not counted");
    }
  }

  /// The two processes of a clock wait for points in time, and each run changes it.
  static bool is_of_clock(const sc_core::sc_process_b& one, std::size_t number,
                          const std::map<std::string, watched_bit*>& clocks) {
    const std::string_view name = one.basename();
    for (const auto& [clock, signal] : clocks) {
      for (const bool rises : {true, false}) {
        if (!name.starts_with(clock + (rises ? "_posedge_action" : "_negedge_action"))) continue;
        signal->add_to_edge(rises, number);
        return true;
      }
    }
    return false;
  }

  /// What the processes of each module may write: what its outputs are bound to, and its own signals.
  void find_drivers(const std::vector<sc_core::sc_object*>& objects,
                    const std::map<const void*, std::size_t>& place) {
    driven_.resize(modules_.size());
    std::vector<bool> is_driven(signals_.size(), false);
    const auto drives = [&](const sc_core::sc_object* module, const void* signal) {
      const auto found = place.find(signal);
      const auto driver = std::ranges::find(modules_, module);
      if (found == place.end() || driver == modules_.end()) return;
      is_driven[found->second] = true;
      if (signals_[found->second]->runs_anything())
        driven_[static_cast<std::size_t>(driver - modules_.begin())].push_back(found->second);
    };
    for (const sc_core::sc_object* each : objects) {
      const sc_core::sc_object* const module = each->get_parent_object();
      if (const auto* const port = dynamic_cast<const sc_core::sc_port_base*>(each)) {
        const std::string_view kind = port->kind();
        if (kind == "sc_out" || kind == "sc_inout") drives(module, whole(port->get_interface()));
      } else {
        drives(module, whole(each));
      }
    }
    for (std::size_t i = 0; i < signals_.size(); ++i) {
      if (!is_driven[i] && signals_[i]->runs_anything()) undriven_.push_back(i);
    }
  }

  void look() override {
    ++looks_;
    before_.clear();
    before_.swap(next_);
    for (const std::size_t module : before_) ran_[module] = false;
    if (looks_at_all_ || looks_ == 1) {
      for (std::size_t i = 0; i < signals_.size(); ++i) look_at(i);
      return;
    }
    for (const std::size_t module : before_) {
      for (const std::size_t signal : driven_[module]) look_at(signal);
    }
    for (const std::size_t signal : undriven_) look_at(signal);
  }

  void look_at(std::size_t signal) {
    if (!signals_[signal]->has_changed()) return;
    for (const std::size_t each : signals_[signal]->change()) count(processes_[each]);
    for (const std::size_t each : signals_[signal]->edge()) count(processes_[each]);
  }

  void count(process& one) {
    if (one.last_look == looks_) return;
    one.last_look = looks_;
    ++one.runs;
    if (one.module == kOutside || ran_[one.module]) return;
    ran_[one.module] = true;
    next_.push_back(one.module);
  }

  std::vector<std::unique_ptr<watched>> signals_;
  std::vector<process> processes_;
  std::vector<const sc_core::sc_object*> modules_;  // with processes
  std::vector<numbers> driven_;                     // signals that run anything, by module
  numbers undriven_;                                // by hosts, clocks and from outside
  numbers before_, next_;  // modules with a process that ran before the update phase, that runs after it
  std::vector<bool> ran_;  // the latter, by module
  std::uint64_t looks_ = 0;
  bool looks_at_all_ = false;
};

process_counter::process_counter() : watch_(std::make_unique<watch>()) {}
process_counter::~process_counter() = default;
std::uint64_t process_counter::runs() const {
  return watch_->runs();
}
std::uint64_t process_counter::runs(const std::string& process) const {
  return watch_->runs(process);
}
void process_counter::look_at_all() {
  watch_->look_at_all();
}

}  // namespace blysk::harness
