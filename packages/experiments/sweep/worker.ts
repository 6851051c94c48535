// A thread of a sweep: is told one piece of work at a time and answers with its row.
import { parentPort } from 'node:worker_threads'
import { rowOf, type Work } from './row.ts'

parentPort!.on('message', ({ job, setting }: Work) => parentPort!.postMessage(rowOf(job, setting)))
