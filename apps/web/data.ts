import type { Rolldown } from 'vite'

/**
 * A module that brings data when it is called. What is built fetches it from a file of its own: no script carries it, and
 * none is read for it. Without a build it comes with the module, as tests and the page's policy want it.
 */
export function asData(context: Rolldown.PluginContext, name: string, data: unknown) {
  const json = JSON.stringify(data)
  if (context.environment.mode !== 'build')
    return { code: `export default () => Promise.resolve(${json})`, map: null, moduleType: 'js' as const }
  const file = context.emitFile({ type: 'asset', name, source: json })
  const address = `import.meta.ROLLUP_FILE_URL_${file}`
  return {
    code: `export default async () => (await fetch(${address})).json()`,
    map: null,
    moduleType: 'js' as const,
  }
}
