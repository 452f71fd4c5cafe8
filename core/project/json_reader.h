#pragma once

#include "core/base/error.h"
#include "core/base/parameters.h"

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <filesystem>
#include <string>
#include <vector>

namespace chiaro::project {

/// Keeps the order in which members were added, so that a saved file reads well in a diff.
using Json = nlohmann::ordered_json;

/// The JSON of a file of at most `limit` bytes. Throws Error naming the file; `remedy` says what file to
/// choose when it isn't JSON.
Json readJson(const std::filesystem::path& file, std::uintmax_t limit, const std::string& remedy);

/// Reads members with the types they must have, and names file, place and member when they have another.
class JsonReader {
public:
    JsonReader(const Json& json, std::string where) : m_json(json), m_where(std::move(where)) {
        if (!json.is_object()) throw Error(m_where, "is not an object", "write it between { and }");
    }

    bool has(const char* key) const { return m_json.contains(key); }
    const Json& at(const char* key) const {
        if (!has(key)) throw Error(m_where, fmt::format("has no \"{}\"", key), "add it");
        return m_json.at(key);
    }
    JsonReader child(const char* key) const { return JsonReader(at(key), m_where + ", " + key); }
    std::vector<JsonReader> children(const char* key) const {
        const Json& list = array(key);
        std::vector<JsonReader> readers;
        for (std::size_t i = 0; i < list.size(); ++i)
            readers.emplace_back(list[i], fmt::format("{}, {} {}", m_where, key, i + 1));
        return readers;
    }

    std::string text(const char* key) const {
        if (!at(key).is_string()) throw wrong(key, "a text in quotes");
        return at(key).get<std::string>();
    }
    void read(const char* key, bool& value) const {
        if (!has(key)) return;
        if (!at(key).is_boolean()) throw wrong(key, "true or false");
        value = at(key).get<bool>();
    }
    void read(const char* key, float& value, double minimum, double maximum) const {
        if (has(key)) value = float(number(at(key), key, minimum, maximum));
    }
    void read(const char* key, int& value, int minimum, int maximum) const {
        if (!has(key)) return;
        if (!at(key).is_number_integer()) throw wrong(key, "a whole number");
        value = int(number(at(key), key, minimum, maximum));
    }
    template <int N>
    void read(const char* key, glm::vec<N, float>& vector) const {
        if (has(key)) vector = vectorFrom<N>(at(key), key);
    }
    void read(const char* key, glm::mat4& matrix) const {
        if (!has(key)) return;
        const Json& list = array(key);
        if (list.size() != 16) throw wrong(key, "16 numbers, column by column");
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = float(number(list[std::size_t(i)], key, -1e9, 1e9));
        if (glm::determinant(matrix) == 0) throw wrong(key, "a matrix that can be inverted");
    }
    std::vector<glm::vec2> points(const char* key) const {
        std::vector<glm::vec2> points;
        for (const Json& point : array(key)) points.push_back(vectorFrom<2>(point, key));
        return points;
    }
    std::vector<std::string> texts(const char* key) const {
        std::vector<std::string> texts;
        for (const Json& text : array(key)) {
            if (!text.is_string()) throw wrong(key, "a list of texts in quotes");
            texts.push_back(text.get<std::string>());
        }
        return texts;
    }
    std::vector<int> integers(const char* key, int minimum, int maximum) const {
        std::vector<int> integers;
        for (const Json& one : array(key)) {
            if (!one.is_number_integer()) throw wrong(key, "whole numbers");
            integers.push_back(int(number(one, key, minimum, maximum)));
        }
        return integers;
    }
    void read(const char* key, double& value, double minimum, double maximum) const {
        if (has(key)) value = number(at(key), key, minimum, maximum);
    }
    template <class Params>
    void params(Params& params) const {
        parametersFromJson(nlohmann::json::parse(m_json.dump()), m_where, params);
    }

    Error wrong(const char* key, const std::string& remedy) const {
        return Error(fmt::format("{}, {}", m_where, key), "is " + at(key).dump().substr(0, 60),
                     "write " + remedy);
    }

private:
    const Json& array(const char* key) const {
        if (!at(key).is_array()) throw wrong(key, "a list between [ and ]");
        return at(key);
    }
    double number(const Json& json, const char* key, double minimum, double maximum) const {
        const bool valid = json.is_number() && json.get<double>() >= minimum && json.get<double>() <= maximum;
        if (!valid) throw wrong(key, fmt::format("a number from {:g} to {:g}", minimum, maximum));
        return json.get<double>();
    }
    template <int N>
    glm::vec<N, float> vectorFrom(const Json& json, const char* key) const {
        if (!json.is_array() || json.size() != N) throw wrong(key, fmt::format("{} numbers", N));
        glm::vec<N, float> vector;
        for (int i = 0; i < N; ++i) vector[i] = float(number(json[std::size_t(i)], key, -1e9, 1e9));
        return vector;
    }

    const Json& m_json;
    std::string m_where;
};

}  // namespace chiaro::project
