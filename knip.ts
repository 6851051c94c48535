import type { KnipConfig } from 'knip'

const config: KnipConfig = {
  // Style sheets name the fonts.
  compilers: {
    css: (text) => [...text.matchAll(/url\('(@[^']+)'\)/g)].map(([, font]) => `import '${font}'`).join('\n'),
  },
  workspaces: {
    '.': { entry: ['scripts/*.{mjs,ts}'], project: ['scripts/**/*.{mjs,ts}'] },
    'apps/web': {
      entry: ['project.inlang/paraglide.config.js'],
      project: ['src/**/*.{ts,svelte,css}'],
      // Named by its path in project.inlang/settings.json.
      ignoreDependencies: ['@inlang/plugin-message-format'],
    },
    benchmarks: { entry: ['*.bench.ts'] },
    e2e: { entry: ['tests/**/*.{spec,touch}.ts'] },
  },
}

export default config
