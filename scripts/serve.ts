// The last step of `npm start`: serves the build on all addresses until it is told to stop.
import { networkInterfaces } from 'node:os'
import root from '../package.json' with { type: 'json' }
import { addresses, greeting } from './addresses.ts'
import { whenParentEnds } from './prepare/parent.mjs'
import { Trouble } from './prepare/run.mjs'
import { startServer } from './server.ts'

const port = Number(process.argv[2])

function explain(error: NodeJS.ErrnoException) {
  if (error.code === 'EADDRINUSE') {
    return `Port ${port} is taken by another program. Choose another one: npm start -- --port ${port + 1}`
  }
  if (error.code === 'EACCES')
    return `Port ${port} is not ours to use. Choose one from 1024 on: npm start -- --port 4173`
  if (error instanceof Trouble) return error.message
  throw error
}

try {
  const server = await startServer({ port })
  console.log(greeting(addresses(server.port, networkInterfaces()), root.version))
  const stop = () => void server.close()
  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP'] as const) process.once(signal, stop)
  whenParentEnds(stop)
} catch (error) {
  console.error(explain(error as NodeJS.ErrnoException))
  process.exitCode = 1
}
