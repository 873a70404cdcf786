// SPDX-License-Identifier: MIT
// Numbers as bytes and back, for plans that another program goes on with on the same machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace cobble::renderer {

class PlanWriter {
  public:
    template <typename T>
    void put(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        put_all(&value, 1);
    }
    template <typename T>
    void put_all(const T* values, std::size_t count) {
        const auto* const begin = reinterpret_cast<const std::uint8_t*>(values);
        bytes_.insert(bytes_.end(), begin, begin + count * sizeof(T));
    }
    [[nodiscard]] std::vector<std::uint8_t> take() { return std::move(bytes_); }

  private:
    std::vector<std::uint8_t> bytes_;
};

class PlanReader {
  public:
    explicit PlanReader(const std::vector<std::uint8_t>& bytes) : bytes_(&bytes) {}

    /// False, and nothing read, if there are not so many bytes left.
    template <typename T>
    [[nodiscard]] bool get(T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        return get_all(&value, 1);
    }
    template <typename T>
    [[nodiscard]] bool get_all(T* values, std::size_t count) {
        if ((bytes_->size() - at_) / sizeof(T) < count) return false;
        if (count > 0) std::memcpy(values, bytes_->data() + at_, count * sizeof(T));
        at_ += count * sizeof(T);
        return true;
    }
    [[nodiscard]] bool at_end() const { return at_ == bytes_->size(); }

  private:
    const std::vector<std::uint8_t>* bytes_;
    std::size_t at_ = 0;
};

}  // namespace cobble::renderer
