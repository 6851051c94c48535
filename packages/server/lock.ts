import { join } from 'node:path'
import { openLock } from '@botgarten/classroom'
import { CannotServe } from './problem.ts'

/** Takes a data folder for this process alone, until it ends in whatever way. @returns gives it free */
export function lockFolder(folder: string): () => void {
  const free = openLock(join(folder, 'server.lock'))
  if (free === null) throw new CannotServe('inUse', { path: folder })
  return free
}
