// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// A fixture with the built-in types, those of sample_types.hpp, and a few more that are hard to encode.
#ifndef OROFORGE_TESTS_ENCODED_TYPES_HPP
#define OROFORGE_TESTS_ENCODED_TYPES_HPP

#include <rtt/encoding/Json.hpp>
#include <rtt/encoding/Plan.hpp>
#include <rtt/types/GeneratedTypekit.hpp>
#include <rtt/types/AdaptedTable.hpp>
#include <rtt/types/ContainerTable.hpp>
#include <rtt/types/StructTypeInfo.hpp>
#include <rtt/types/VariantTable.hpp>

#include <list>
#include <stdexcept>
#include <variant>

#include "../types/builtin_typekit.hpp"
#include "../types/sample_types.hpp"

namespace encoded {

/** Its first field ends where the second one needs another alignment. */
struct Mixed {
    bool on = false;
    std::int16_t step = 0;
    float gain = 0;
    double sum = 0;
    char letter = 0;
};
struct Nothing {};
struct Tree {
    int value = 0;
    std::vector<Tree> branches;
};
/** Its typekit is user code. */
struct Foreign {
    int a = 0;
    double b = 0;
};

/** Its function gives a copy to the archive. */
struct Partial {
    int a = 0, b = 0;
    template <class Archive>
    void serialize(Archive& archive, unsigned) {
        int copy = b;
        archive& boost::serialization::make_nvp("a", a) & boost::serialization::make_nvp("b", copy);
        b = copy;
    }
};
enum class Switch : bool { Off, On };
struct Matrix {
    std::size_t rows = 0, columns = 0;
    std::vector<int> numbers;
};
/** As generated code for an adapter has it. */
struct MatrixAccess {
    using Object = Matrix;
    using Element = int;
    using Row = std::vector<int>;
    static constexpr bool canResize = true, fixedRows = false, fixedColumns = false;
    static std::size_t rows(const Matrix& matrix) { return matrix.rows; }
    static std::size_t columns(const Matrix& matrix) { return matrix.columns; }
    static void resize(Matrix& matrix, std::size_t rows, std::size_t columns) {
        matrix.rows = rows;
        matrix.columns = columns;
        matrix.numbers.resize(rows * columns);
    }
    static void load(const Matrix& matrix, std::size_t row, std::size_t column, int& to) {
        to = matrix.numbers[row * matrix.columns + column];
    }
    static void store(Matrix& matrix, std::size_t row, std::size_t column, int from) {
        matrix.numbers[row * matrix.columns + column] = from;
    }
};
class Picky {
public:
    int level() const { return level_; }
    void setLevel(int level) {
        if (level < 0) throw std::invalid_argument("below 0");
        level_ = level;
    }

private:
    int level_ = 0;
};
struct Unknown {
    int value = 0;
};
typedef std::variant<int, Unknown> Choice;

namespace t = RTT::types;

inline constexpr t::SequenceOps levelAccess =
    t::memberAccess([](const void* object, std::size_t,
                       void* to) { *static_cast<int*>(to) = static_cast<const Picky*>(object)->level(); },
                    [](void* object, std::size_t, const void* from) {
                        static_cast<Picky*>(object)->setLevel(*static_cast<const int*>(from));
                    });
inline constexpr t::Member pickyMembers[] = {{"level", 0, &t::typeRef<int>, 0, "", "", nullptr, &levelAccess}};
inline constexpr t::Enumerator switchValues[] = {{"Off", 0, ""}, {"On", 1, ""}};
inline constexpr const char* choiceNames[] = {"int", "unknown"};

inline constexpr t::Member mixedMembers[] = {
    {"on", offsetof(Mixed, on), &t::typeRef<bool>, 0, "", ""},
    {"step", offsetof(Mixed, step), &t::typeRef<std::int16_t>, 0, "", ""},
    {"gain", offsetof(Mixed, gain), &t::typeRef<float>, 0, "", ""},
    {"sum", offsetof(Mixed, sum), &t::typeRef<double>, 0, "", ""},
    {"letter", offsetof(Mixed, letter), &t::typeRef<char>, 0, "", ""},
};
inline constexpr t::Member treeMembers[] = {
    {"value", offsetof(Tree, value), &t::typeRef<int>, 0, "", ""},
    {"branches", offsetof(Tree, branches), &t::typeRef<std::vector<Tree>>, 0, "", ""},
};

class ForeignInfo : public t::TemplateTypeInfo<Foreign>, public t::MemberFactory {
public:
    ForeignInfo() : t::TemplateTypeInfo<Foreign>("/encoded/Foreign") {}
    bool installTypeInfoObject(t::TypeInfo* info) override {
        t::TemplateTypeInfo<Foreign>::installTypeInfoObject(info);
        info->setMemberFactory(boost::dynamic_pointer_cast<ForeignInfo>(getSharedPtr()));
        return false;
    }
    std::vector<std::string> getMemberNames() const override { return {"a", "b"}; }
    using t::MemberFactory::getMember;
    RTT::base::DataSourceBase::shared_ptr getMember(RTT::base::DataSourceBase::shared_ptr item,
                                                    const std::string& name) const override {
        auto* const value = static_cast<Foreign*>(item->getRawPointer());
        if (name == "a") return new RTT::internal::PartDataSource<int>(value->a, item);
        if (name == "b") return new RTT::internal::PartDataSource<double>(value->b, item);
        return nullptr;
    }
};

class EncodedTypes : public types_test::WithBuiltinTypes {
protected:
    static void SetUpTestSuite() {
        types_test::WithBuiltinTypes::SetUpTestSuite();
        sample::addTypes();
        const auto types = t::Types();
        types->addType(t::makeStructType<Mixed>("/encoded/Mixed", mixedMembers, 5));
        types->addType(t::makeSequenceType<std::vector<Mixed>>("/std/vector</encoded/Mixed>"));
        types->addType(t::makeStructType<Nothing>("/encoded/Nothing", nullptr, 0));
        types->addType(t::makeStructType<Tree>("/encoded/Tree", treeMembers, 2));
        types->addType(t::makeSequenceType<std::vector<Tree>>("/std/vector</encoded/Tree>"));
        types->addType(new ForeignInfo());
        types->addType(new t::StructTypeInfo<Partial>("/encoded/Partial"));
        types->addType(t::makeEnumType<Switch>("/encoded/Switch", switchValues, 2));
        types->addType(t::makeSequenceType<std::vector<int>>("/std/vector</int>"));
        types->addType(t::makeAdaptedMatrix<MatrixAccess>("/encoded/Matrix", ""));
        types->addType(t::makeStructType<Picky>("/encoded/Picky", pickyMembers, 1));
        types->addType(t::detail::newSequenceGenerator("/std/list</int>", t::linkedOps<std::list<int>>(),
                                                       t::typeOps<std::list<int>>(), t::typeThunks<std::list<int>>()));
        types->addType(t::makeVariantType<Choice>("/encoded/Choice", choiceNames));
    }

    /** The plan for values of type T. */
    template <class T>
    static std::shared_ptr<const RTT::encoding::Plan> planOf(
        const RTT::encoding::Rules& rules = RTT::encoding::cdrRules()) {
        std::string why;
        auto plan = RTT::encoding::Plan::make(*t::Types()->getTypeInfo<T>(), rules, why);
        EXPECT_TRUE(plan) << why;
        return plan;
    }
    template <class T>
    static std::shared_ptr<const RTT::encoding::Json> jsonOf() {
        std::string why;
        auto json = RTT::encoding::Json::make(*t::Types()->getTypeInfo<T>(), why);
        EXPECT_TRUE(json) << why;
        return json;
    }
    template <class T>
    static std::string bytesOf(const T& value, const RTT::encoding::Rules& rules = RTT::encoding::cdrRules()) {
        const auto plan = planOf<T>(rules);
        std::string bytes(plan->sizeOf(&value), 'x');
        bytes.resize(plan->encode(&value, &bytes[0], bytes.size()));
        return bytes;
    }
    template <class T>
    static RTT::encoding::DecodeError decode(const std::string& bytes, T& value,
                                             RTT::encoding::ByteOrder order = RTT::encoding::ByteOrder::Little,
                                             const RTT::encoding::Rules& rules = RTT::encoding::cdrRules()) {
        return planOf<T>(rules)->decode(bytes.data(), bytes.size(), order, &value);
    }
};

}  // namespace encoded

#endif
