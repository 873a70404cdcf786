// SPDX-License-Identifier: MIT
// Numbers as bytes, the lowest first, whatever the machine: what a job's state is written in.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace cobble::renderer {

/// The unsigned number that has the bits of a float, a double, or itself.
template <typename T>
using BitsOf = std::conditional_t<sizeof(T) == 8, std::uint64_t,
                                  std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint8_t>>;

class StateWriter {
  public:
    template <typename T>
    void put(T value) {
        const auto bits = std::bit_cast<BitsOf<T>>(value);
        std::array<char, sizeof(T)> bytes;
        for (std::size_t i = 0; i < sizeof(T); ++i) {
            bytes[i] = static_cast<char>(static_cast<std::uint8_t>(bits >> (8 * i)));
        }
        bytes_.append(bytes.data(), bytes.size());
    }
    /// What a reader can tell from other parts and find the end of without knowing it: how long its
    /// name is, its name, how long it is, and itself.
    void put_part(std::string_view name, const StateWriter& part) {
        put(static_cast<std::uint8_t>(name.size()));
        bytes_ += name;
        put(std::uint64_t{part.bytes_.size()});
        bytes_ += part.bytes_;
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] std::string take() { return std::move(bytes_); }

  private:
    std::string bytes_;
};

/// Reads what a StateWriter wrote. Whatever is asked for beyond the end is 0 or empty, and from
/// then on nothing is sound.
class StateReader {
  public:
    explicit StateReader(std::string_view bytes) : bytes_(bytes) {}

    template <typename T>
    T take() {
        BitsOf<T> bits = 0;
        const std::string_view bytes = take_bytes(sizeof(T));
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            const auto byte = static_cast<std::uint8_t>(bytes[i]);
            bits = static_cast<BitsOf<T>>(bits | static_cast<BitsOf<T>>(byte) << (8 * i));
        }
        return std::bit_cast<T>(bits);
    }

    struct Part {
        std::string_view name, bytes;
    };
    Part take_part() {
        const auto name_size = take<std::uint8_t>();
        const std::string_view name = take_bytes(name_size);
        const auto size = take<std::uint64_t>();
        return {name, take_bytes(size)};
    }

    [[nodiscard]] bool at_end() const { return bytes_.empty(); }
    /// Nothing was missing so far.
    [[nodiscard]] bool sound() const { return sound_; }

  private:
    std::string_view take_bytes(std::uint64_t count) {
        if (count > bytes_.size()) {
            sound_ = false;
            bytes_ = {};
        }
        const std::string_view taken = bytes_.substr(0, static_cast<std::size_t>(count));
        bytes_.remove_prefix(taken.size());
        return taken;
    }

    std::string_view bytes_;
    bool sound_ = true;
};

}  // namespace cobble::renderer
