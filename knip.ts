import type { KnipConfig } from 'knip'

const config: KnipConfig = {
  // Style sheets name the fonts.
  compilers: {
    css: (text) => [...text.matchAll(/url\('(@[^']+)'\)/g)].map(([, font]) => `import '${font}'`).join('\n'),
  },
  workspaces: {
    // The binaries are of Linux, for a root of its own in which a zip is tried, and for the image of a card.
    '.': {
      entry: [
        'scripts/*.{mjs,ts}',
        'scripts/image/pi/{prepare,screen,stick,trial}.ts',
        'scripts/testing/fast-check.ts',
        'scripts/gate/file-results.mjs',
      ],
      project: ['scripts/**/*.{mjs,ts}'],
      ignoreBinaries: [
        ...[
          'ldd',
          'unshare',
          'dpkg-query',
          'xz',
          'mtype',
          'mcopy',
          'findmnt',
          'truncate',
          'mkfs.vfat',
          'debugfs',
          'e2fsck',
          'dd',
        ],
      ],
    },
    'apps/web': {
      project: ['src/**/*.{ts,svelte,css}'],
      // `content:…` is what vite.config makes of content/.
      ignoreDependencies: ['content'],
    },
    // Of the system, for a small disk that fills up; the test says why where they are missing.
    'packages/classroom': {
      entry: ['projects/check-worker.ts', 'testing/child-process.ts'],
      ignoreBinaries: ['mount', 'umount'],
    },
    'packages/server': { entry: ['content-worker.ts', 'rehearsal/process.ts'] },
    // The contract test finds them by the folder they lie in.
    'packages/learning': { entry: ['*/testing/example.ts'] },
    // A process of its own, and a function of a test.
    'packages/programs': { entry: ['python/testing/worker.ts'] },
    benchmarks: { entry: ['*.bench.ts', 'worst/attacker.ts'], ignoreBinaries: ['taskset'] },
    e2e: {
      entry: [
        ...['saved-work.ts', 'file-results.mjs'],
        ...['{tests,gate}/**/*.{spec,touch}.ts', 'walk/*.walk.ts'],
      ],
    },
  },
}

export default config
