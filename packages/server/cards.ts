import { Worker } from 'node:worker_threads'
import type { CardOfClass } from '@botgarten/classroom'

function read(): Promise<readonly CardOfClass[]> {
  const worker = new Worker(new URL('./cards-worker.ts', import.meta.url))
  return new Promise((resolve, reject) => {
    worker.once('message', resolve)
    worker.once('error', reject)
    // After its answer this changes nothing.
    worker.once('exit', () => reject(new Error('The cards were not read.')))
  })
}

/** All cards, read when they are first asked for. */
export function cardsInWorker(): () => Promise<readonly CardOfClass[]> {
  let cards: Promise<readonly CardOfClass[]> | null = null
  return () => {
    cards ??= read().catch((error: unknown) => {
      cards = null
      throw error
    })
    return cards
  }
}
