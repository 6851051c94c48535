// `npm run build:static`: the product as files for any web space, without a server.
import { buildStatic, webSpace } from './prepare/build.mjs'
import { asScript } from './prepare/run.mjs'

await asScript(async () => {
  await buildStatic()
  console.log(`\nPut what lies in ${webSpace} into any folder of a web space.`)
  console.log('What you write into its operator.md stands on the page "about".')
  return 0
})
