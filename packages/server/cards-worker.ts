// Reads the cards beside the thread that answers: what reading takes of the memory is given back with the worker.
import { parentPort } from 'node:worker_threads'
import { content } from '@botgarten/content/files'

parentPort!.postMessage(content.cards.map(({ id, starts, title }) => ({ id, starts, title })))
