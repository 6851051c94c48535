import { Worker } from 'node:worker_threads'
import type { CardOfClass, Questionnaires } from '@botgarten/classroom'
import type { Part } from './content-worker.ts'

function read<Content>(part: Part): Promise<Content> {
  const worker = new Worker(new URL('./content-worker.ts', import.meta.url), { workerData: part })
  return new Promise((resolve, reject) => {
    worker.once('message', resolve)
    worker.once('error', reject)
    // After its answer this changes nothing.
    worker.once('exit', () => reject(new Error('The content was not read.')))
  })
}

/** Reads a part of the content when it is first asked for. */
function inWorker<Content>(part: Part): () => Promise<Content> {
  let found: Promise<Content> | null = null
  return () => {
    found ??= read<Content>(part).catch((error: unknown) => {
      found = null
      throw error
    })
    return found
  }
}

/** All cards. */
export const cardsInWorker = (): (() => Promise<readonly CardOfClass[]>) => inWorker('cards')

/** All questionnaires, and the questions that they may ask. */
export const questionnairesInWorker = (): (() => Promise<Questionnaires>) => inWorker('questionnaires')
