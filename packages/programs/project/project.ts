import * as v from 'valibot'
import type { Project } from '../types.ts'
import { ProjectError } from './error.ts'
import { issueError } from './issue.ts'
import { refuseBigText, refuseOversize } from './limits.ts'
import { knowParts } from './refusal.ts'
import { projectSchema } from './schema.ts'
import { newest } from './versions.ts'

/**
 * A project from a file's text or from foreign data. Nothing of it is trusted; what comes out is fresh plain data of
 * the shape `Project`, blocks of unknown type included.
 * @throws {ProjectError} and nothing else
 */
export function parseProject(source: unknown): Project {
  const data = typeof source === 'string' ? dataIn(source) : source
  refuseOversize(data)
  refuseNewer(data)
  const result = v.safeParse(projectSchema, data, { abortEarly: true })
  if (!result.success) throw issueError(result.issues[0], data)
  knowParts(result.output)
  return result.output
}

function dataIn(text: string): unknown {
  refuseBigText(text)
  try {
    return JSON.parse(text)
  } catch {
    throw new ProjectError('notJson', 'This is not JSON.')
  }
}

function refuseNewer(data: unknown): void {
  const version = typeof data === 'object' && data !== null && 'botgarten' in data ? data.botgarten : null
  if (typeof version !== 'number' || !(version > newest)) return
  const message = `The project has version ${version}; this Botgarten reads up to ${newest}.`
  throw new ProjectError('newerVersion', message, { version })
}
