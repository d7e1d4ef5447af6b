// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How log4cpp comes to make categories of ours. The log4cpp of Debian has no factory: its one HierarchyMaintainer, a
// static object of the library, makes plain categories. But that class has virtual functions, and the library reaches
// the object through a reference and its table of functions only. So the object is ended, and one of a derived class of
// the same size takes its place, with the same categories. Before static objects are destroyed, a plain one comes back.
#include <ocl/Category.hpp>

#include <rtt/Logger.hpp>

#include <log4cpp/HierarchyMaintainer.hh>

#include <memory>
#include <mutex>
#include <new>
#include <utility>

namespace OCL::logging {
namespace {

using log4cpp::HierarchyMaintainer;
using Handlers = std::vector<HierarchyMaintainer::shutdown_fun_ptr>;

// An explicit instantiation may name private members.
Handlers& handlersOf(HierarchyMaintainer& maintainer);
template <auto Member>
struct Reveal {
    friend Handlers& handlersOf(HierarchyMaintainer& maintainer) { return maintainer.*Member; }
};
template struct Reveal<&HierarchyMaintainer::handlers_>;

class Maintainer final : public HierarchyMaintainer {
public:
    static CategoryMap& categoriesOf(HierarchyMaintainer& maintainer) {
        return maintainer.*(&Maintainer::_categoryMap);
    }
    log4cpp::Category& getInstance(const std::string& name) override {
        isUsed = true;
        return HierarchyMaintainer::getInstance(name);
    }

    static std::atomic<Category::Factory> factory;
    static std::atomic<bool> isUsed;

protected:
    // log4cpp calls it with the mutex of the map locked.
    log4cpp::Category& _getInstance(const std::string& name) override {
        if (log4cpp::Category* const existing = _getExistingInstance(name)) return *existing;
        const Category::Factory make = factory;
        std::unique_ptr<log4cpp::Category> made;
        if (name.empty()) {
            made.reset(make(name, nullptr, log4cpp::Priority::INFO));
        } else {
            const std::size_t dot = name.rfind('.');
            log4cpp::Category& parent = _getInstance(dot == std::string::npos ? std::string() : name.substr(0, dot));
            made.reset(make(name, &parent, log4cpp::Priority::NOTSET));
        }
        log4cpp::Category*& place = _categoryMap[name];
        place = made.release();
        return *place;
    }
};

std::atomic<Category::Factory> Maintainer::factory{nullptr};
std::atomic<bool> Maintainer::isUsed{false};

static_assert(sizeof(Maintainer) == sizeof(HierarchyMaintainer) && alignof(Maintainer) == alignof(HierarchyMaintainer));

/** Puts a T into the place of `old`, with its categories and handlers. */
template <class T>
void replace(HierarchyMaintainer& old) {
    HierarchyMaintainer::CategoryMap categories;
    Handlers handlers;
    categories.swap(Maintainer::categoriesOf(old));
    handlers.swap(handlersOf(old));
    old.~HierarchyMaintainer();
    HierarchyMaintainer* const made = new (static_cast<void*>(&old)) T;
    Maintainer::categoriesOf(*made).swap(categories);
    handlersOf(*made).swap(handlers);
}

/** From its construction to the end of the process, log4cpp makes categories of ours. */
class Installation {
public:
    Installation() { replace<Maintainer>(log4cpp::HierarchyMaintainer::getDefaultMaintainer()); }
    ~Installation() {
        HierarchyMaintainer& mine = present();
        mine.shutdown();
        // Other threads may log until the very end, so the categories stay.
        static auto& kept = *new HierarchyMaintainer::CategoryMap;
        kept.swap(Maintainer::categoriesOf(mine));
        replace<HierarchyMaintainer>(mine);
    }
    Installation(const Installation&) = delete;
    Installation& operator=(const Installation&) = delete;

private:
    static HierarchyMaintainer& present() {
        return *std::launder(&log4cpp::HierarchyMaintainer::getDefaultMaintainer());
    }
};

}  // namespace

bool Category::installFactory(Factory factory) {
    Maintainer::factory = factory ? factory : &Category::createOCLCategory;
    static const bool works = [] {
        static Installation installation;
        // Finds out whether log4cpp uses the object; the root exists from now on.
        Maintainer::isUsed = false;
        (void)log4cpp::Category::getInstance("");
        return Maintainer::isUsed.load();
    }();
    if (!works)
        RTT::log(RTT::Error) << "this version of log4cpp does not let OCL::logging make its categories; only those of "
                                "log4cpp are available, and real-time threads cannot use them"
                             << RTT::endlog();
    return works;
}

}  // namespace OCL::logging
