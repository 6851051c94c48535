import type { Database } from '../database/database.ts'
import { NoRoom } from './room-store.ts'
import { saveInside, type Save, type Saved } from './saves-store.ts'
import type { Space } from './space-store.ts'

export type SaveQueue = (save: Save) => Promise<Saved>

interface Waiting {
  readonly save: Save
  readonly resolve: (saved: Saved) => void
  readonly reject: (error: unknown) => void
}

/** Bytes of projects after which the journal is put away: a version takes the pages of the one that goes for it. */
const journalBytes = 2_000_000

const bytesOf = ({ checked: { document, assets } }: Save) =>
  assets.reduce((sum, { base64 }) => sum + base64.length, document.length)

/**
 * Saves that wait share one commit, and with it one wait for the disk. Answers come after the commit. On PostgreSQL each
 * has a connection of its own, and the server itself joins commits.
 */
export function saveQueueOn({ kind, db, checkpoint }: Database, mostSpace?: Space): SaveQueue {
  const alone = async (save: Save): Promise<Saved> => {
    try {
      return await db.transaction().execute((inside) => saveInside(inside, save, mostSpace))
    } catch (error) {
      if (error instanceof NoRoom) return { kind: error.full }
      throw error
    }
  }
  if (kind === 'postgres') return alone

  let waiting: Waiting[] = []
  let running = false
  let written = 0

  /** Between saves: whoever saves next would wait for it. */
  function tidy() {
    if (running || written < journalBytes) return
    written = 0
    try {
      checkpoint?.()
    } catch {
      // A full disk, or a server that has closed: nothing is lost, and a later commit does it.
    }
  }

  async function together(batch: readonly Waiting[]) {
    try {
      const answers = await db.transaction().execute(async (inside) => {
        const all: Saved[] = []
        for (const { save } of batch) all.push(await saveInside(inside, save, mostSpace))
        return all
      })
      batch.forEach(({ resolve }, at) => resolve(answers[at]!))
    } catch (error) {
      const full = error instanceof NoRoom ? batch.find(({ save }) => save === error.owner) : undefined
      // The one without room took the others along: they go again without it.
      if (full && error instanceof NoRoom) {
        full.resolve({ kind: error.full })
        const others = batch.filter((one) => one !== full)
        if (others.length > 0) await together(others)
        return
      }
      // One of them is at fault: each again by itself.
      for (const { save, resolve, reject } of batch) await alone(save).then(resolve, reject)
    }
  }

  async function work() {
    running = true
    while (waiting.length > 0) {
      const batch = waiting
      waiting = []
      await together(batch)
      written += batch.reduce((sum, { save }) => sum + bytesOf(save), 0)
    }
    running = false
    // After the answers are on their way.
    if (written >= journalBytes) setImmediate(tidy)
  }

  return (save) =>
    new Promise((resolve, reject) => {
      waiting.push({ save, resolve, reject })
      if (!running) void work()
    })
}
