import type { Database } from '../database/database.ts'
import { ClassFull, saveInside, type Save, type Saved } from './saves-store.ts'

export type SaveQueue = (save: Save) => Promise<Saved>

interface Waiting {
  readonly save: Save
  readonly resolve: (saved: Saved) => void
  readonly reject: (error: unknown) => void
}

/**
 * Saves that wait share one commit, and with it one wait for the disk. Answers come after the commit. On PostgreSQL each
 * has a connection of its own, and the server itself joins commits.
 */
export function saveQueueOn({ kind, db }: Database, mostSpace?: number): SaveQueue {
  const alone = async (save: Save): Promise<Saved> => {
    try {
      return await db.transaction().execute((inside) => saveInside(inside, save, mostSpace))
    } catch (error) {
      if (error instanceof ClassFull) return { kind: 'classFull' }
      throw error
    }
  }
  if (kind === 'postgres') return alone

  let waiting: Waiting[] = []
  let running = false

  async function together(batch: readonly Waiting[]) {
    try {
      const answers = await db.transaction().execute(async (inside) => {
        const all: Saved[] = []
        for (const { save } of batch) all.push(await saveInside(inside, save, mostSpace))
        return all
      })
      batch.forEach(({ resolve }, at) => resolve(answers[at]!))
    } catch {
      // One of them is at fault and took the others along: each again by itself.
      for (const { save, resolve, reject } of batch) await alone(save).then(resolve, reject)
    }
  }

  async function work() {
    running = true
    while (waiting.length > 0) {
      const batch = waiting
      waiting = []
      await together(batch)
    }
    running = false
  }

  return (save) =>
    new Promise((resolve, reject) => {
      waiting.push({ save, resolve, reject })
      if (!running) void work()
    })
}
