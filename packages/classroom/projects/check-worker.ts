// Checks projects beside the thread that answers requests: a file that is slow to read holds up nobody else.
import { setPriority } from 'node:os'
import { parentPort, workerData } from 'node:worker_threads'
import { checkProject } from './checked.ts'

// Linux gives threads priorities of their own: on a single core requests come before large projects.
if (workerData === 'large' && process.platform === 'linux') setPriority(10)

parentPort!.on('message', ({ id, text }: { id: number; text: string }) => {
  try {
    parentPort!.postMessage({ id, checked: checkProject(text) })
  } catch {
    parentPort!.postMessage({ id, checked: { refused: 'notAProject' } })
  }
})

parentPort!.postMessage('ready')
