// `npm start`. Runs on any Node from 20.19 on and hands over to the Node that the install brings along.
import { spawn } from 'node:child_process'
import { buildWhenNeeded } from './prepare/build.mjs'
import { house, inHouse } from './prepare/house.mjs'
import { installWhenNeeded } from './prepare/install.mjs'
import { whenParentEnds } from './prepare/parent.mjs'
import { portFrom } from './prepare/port.mjs'
import { asScript } from './prepare/run.mjs'
import { runtime } from './prepare/runtime.mjs'

function serve(port) {
  const args = ['--disable-warning=ExperimentalWarning', inHouse('scripts', 'serve.ts'), String(port)]
  const server = spawn(runtime(), args, { cwd: house, stdio: 'inherit' })
  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.on(signal, () => server.kill(signal))
  // Who calls this script from a shell of their own may leave that shell and keep the lab.
  if (process.env.npm_lifecycle_event) whenParentEnds(() => server.kill('SIGTERM'))
  return new Promise((done) => server.once('exit', (code) => done(code ?? 1)))
}

await asScript(async () => {
  const port = portFrom(process.argv.slice(2))
  await installWhenNeeded()
  await buildWhenNeeded()
  return serve(port)
})
