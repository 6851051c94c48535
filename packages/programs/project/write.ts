import type { Project } from '../types.ts'
import { version } from '../version.ts'
import { inFile } from './any-brain.ts'
import { refusalOf } from './refusal.ts'
import { withVersion } from './versions.ts'

/** One line of JSON. What `parseProject` made comes back from it the same. */
export const writeProject = (project: Project): string => JSON.stringify(inFile(withVersion(project)))

/**
 * The same for a file that leaves the device: it also says which version wrote it. That is of the file and not of the
 * project: readers of every version leave it out, so that a project read from it equals the one that was written.
 */
export function writeProjectFile(project: Project): string {
  const { botgarten, ...others } = withVersion(project)
  const file = { botgarten, madeWith: version, ...others }
  // A project that is only just small enough to be read has to stay so.
  return writeProject(refusalOf(file) ? project : file)
}
