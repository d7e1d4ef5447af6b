#ifndef ACTS_EVENT_HPP
#define ACTS_EVENT_HPP

#include <acts/EventBase.hpp>

namespace acts {

/// Ports, properties and attributes are members of the base class: EventBase, generated from acts.xml.
class Event : public EventBase {
public:
    explicit Event(const std::string& name);
    ~Event() override;

protected:
    bool startHook() override;
    void stopHook() override;
    void cleanupHook() override;
};

}  // namespace acts

#endif
