import type * as v from 'valibot'
import { ProjectError, type Limit } from './error.ts'
import { longestKey } from './limits.ts'
import { problemOf } from './schema-card.ts'

type Issue = v.BaseIssue<unknown>

/** What a schema found, as the error that a reader throws. */
export const issueError = (issue: Issue, data: unknown): ProjectError =>
  new ProjectError(problemOf(issue.message) ?? 'notAProject', describe(issue), {}, limitIn(issue, data))

export const keysOf = (issue: Issue): readonly unknown[] => issue.path?.map(({ key }) => key) ?? []

function describe(issue: Issue): string {
  const path = keysOf(issue).map(String).join('.')
  return path === '' ? issue.message : `${path}: ${issue.message}`
}

function limitIn(issue: Issue, data: unknown): Limit | undefined {
  if (issue.type !== 'max_length') return undefined
  const most = Number(issue.requirement)
  const kind = typeof issue.input !== 'string' ? 'count' : most <= longestKey ? 'name' : 'text'
  const block = blockAt(keysOf(issue), data)
  return { kind, most, ...(block !== undefined && { block }) }
}

/** The id of the innermost block on the way. */
function blockAt(keys: readonly unknown[], data: unknown): string | undefined {
  let found: string | undefined
  let part = data
  for (const key of keys) {
    if (typeof part !== 'object' || part === null) break
    const { id, type } = part as { id?: unknown; type?: unknown }
    if (typeof id === 'string' && typeof type === 'string') found = id
    part = (part as { [key: string]: unknown })[String(key)]
  }
  return found
}
