// A thread of a sweep: is told one setting at a time and answers with its row.
import { parentPort, workerData } from 'node:worker_threads'
import type { Setting } from './grid.ts'
import { rowOf, type Job } from './runs.ts'

parentPort!.on('message', (setting: Setting) => parentPort!.postMessage(rowOf(workerData as Job, setting)))
