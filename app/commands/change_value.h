#pragma once

#include "app/commands/project_command.h"

#include <functional>
#include <utility>

namespace chiaro::app {

/// Replaces one value of the project. Changes of the same value in the same session (a drag, a dialog) become
/// one entry, which vanishes when the value ends as it began.
template <class Value>
class ChangeValue : public ProjectCommand {
public:
    struct Access {
        std::function<Value(const project::Project&)> get;
        std::function<void(project::Project&, const Value&)> set;
    };

    ChangeValue(Document& document, Change change, const QString& text, int session, Access access,
                Value value)
        : ProjectCommand(document, change, text),
          m_session(session),
          m_access(std::move(access)),
          m_before(m_access.get(project())),
          m_after(std::move(value)) {}

    bool changesNothing() const { return m_before == m_after; }

    void undo() override { put(m_before); }
    void redo() override { put(m_after); }

    int id() const override { return int(change().kind) << 20 | change().index; }
    bool mergeWith(const QUndoCommand* command) override {
        const auto* next = dynamic_cast<const ChangeValue*>(command);
        if (!next || next->m_session != m_session) return false;
        m_after = next->m_after;
        setObsolete(changesNothing());
        return true;
    }

private:
    void put(const Value& value) {
        m_access.set(project(), value);
        tell();
    }

    int m_session;
    Access m_access;
    Value m_before;
    Value m_after;
};

}  // namespace chiaro::app
