import { build } from './prepare/build.mjs'
import { asScript } from './prepare/run.mjs'

await asScript(async () => {
  await build()
  return 0
})
