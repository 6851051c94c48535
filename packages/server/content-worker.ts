// Reads cards and questionnaires beside the thread that answers: what reading takes of the memory is given back with the worker.
import { parentPort, workerData } from 'node:worker_threads'
import { content } from '@botgarten/content/files'

const readers = {
  cards: () => content.cards.map(({ id, starts, title }) => ({ id, starts, title })),
  questionnaires: () => ({ forms: content.forms, questions: content.questions }),
}
export type Part = keyof typeof readers

parentPort!.postMessage(readers[workerData as Part]())
