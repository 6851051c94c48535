// Checks projects beside the thread that answers requests: a file that is slow to read holds up nobody else.
import { parentPort } from 'node:worker_threads'
import { checkProject } from './checked.ts'

parentPort!.on('message', ({ id, text }: { id: number; text: string }) => {
  try {
    parentPort!.postMessage({ id, checked: checkProject(text) })
  } catch {
    parentPort!.postMessage({ id, checked: { refused: 'notAProject' } })
  }
})

parentPort!.postMessage('ready')
