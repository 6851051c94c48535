// `npm start`. Runs on any Node from 20.19 on and hands over to the Node that the install brings along.
import { spawn } from 'node:child_process'
import { buildWhenNeeded } from './prepare/build.mjs'
import { house, inHouse } from './prepare/house.mjs'
import { installWhenNeeded } from './prepare/install.mjs'
import { asScript } from './prepare/run.mjs'
import { runtime } from './prepare/runtime.mjs'
import { serverEnv, serverFlags } from '../packages/server/flags.mjs'
import { whenParentEnds } from '../packages/server/parent.mjs'

/** @param {readonly string[]} options */
function serve(options) {
  const cli = inHouse('apps', 'cli', 'botgarten.ts')
  const env = { ...process.env, ...serverEnv, BOTGARTEN_ENDS_WITH_PARENT: '1' }
  const args = ['--disable-warning=ExperimentalWarning', ...serverFlags, cli, 'serve', ...options]
  const server = spawn(runtime(), args, { cwd: house, env, stdio: 'inherit' })
  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.on(signal, () => server.kill(signal))
  // Who calls this script from a shell of their own may leave that shell and keep the lab.
  if (process.env.npm_lifecycle_event) whenParentEnds(() => server.kill('SIGTERM'))
  return new Promise((done) => server.once('exit', (code) => done(code ?? 1)))
}

await asScript(async () => {
  await installWhenNeeded()
  await buildWhenNeeded()
  return serve(process.argv.slice(2))
})
