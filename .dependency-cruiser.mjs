// The arrows of the house: browsers, numbers ← learning, simulation ← blocks ← programs ← lab, maps ← experiments ← content ← answers ← classroom ← server, apps; messages ← apps.
const rooms = [
  'browsers',
  'numbers',
  'learning',
  'simulation',
  'blocks',
  'programs',
  'lab',
  'maps',
  'experiments',
  'content',
  'answers',
  'messages',
  'classroom',
  'server',
  'chromium',
]
const mayKnow = {
  browsers: [],
  numbers: [],
  messages: [],
  chromium: [],
  learning: ['numbers'],
  simulation: ['numbers'],
  blocks: ['learning', 'simulation', 'numbers'],
  programs: ['blocks', 'learning', 'simulation', 'numbers'],
  lab: ['programs', 'blocks', 'learning', 'simulation', 'numbers'],
  maps: ['programs', 'blocks', 'learning', 'simulation', 'numbers'],
  experiments: ['lab', 'maps', 'programs', 'blocks', 'learning', 'simulation', 'numbers', 'browsers'],
  // Reads forms, and what was answered to them.
  answers: ['content', 'numbers'],
  // To check what is uploaded, to read forms and to count answers; nothing of the lab.
  classroom: ['programs', 'content', 'answers'],
  // One process for lab and class: real clock, disk, sockets.
  server: ['classroom', 'content'],
  content: ['experiments', 'lab', 'maps', 'programs', 'blocks', 'learning', 'simulation', 'numbers'],
}
const path = (room) => `^packages/${room}/`

/** Rooms of the web app, from below: each may know those before it. */
const webRooms = [
  'words',
  'drawing',
  'content',
  'storage',
  'parts',
  'figures',
  'lab',
  'features',
  'app',
  'routes',
]
const testing = '(\\.test\\.ts|/testing/.*|test-bench\\.ts)$'

export default {
  forbidden: [
    {
      name: 'no-circles',
      severity: 'error',
      from: {},
      to: { circular: true, viaOnly: { dependencyTypesNot: ['type-only'] } },
    },
    ...rooms.map((room) => ({
      name: `what-${room}-may-know`,
      severity: 'error',
      from: { path: path(room), pathNot: '\\.test\\.ts$' },
      to: { path: '^(packages|apps|content|e2e|benchmarks)/', pathNot: [room, ...mayKnow[room]].map(path) },
    })),
    {
      name: 'tests-keep-to-the-arrows',
      severity: 'error',
      from: { path: '^packages/.*\\.test\\.ts$' },
      to: { path: '^(apps|e2e|benchmarks)/' },
    },
    { name: 'nobody-imports-an-app', severity: 'error', from: { pathNot: '^apps/' }, to: { path: '^apps/' } },
    {
      name: 'apps-do-not-know-each-other',
      severity: 'error',
      from: { path: '^apps/([^/]+)/' },
      to: { path: '^apps/', pathNot: '^apps/$1/' },
    },
    {
      name: 'the-product-knows-no-tools',
      severity: 'error',
      from: { path: '^(packages|apps|content)/', pathNot: '\\.test\\.ts$' },
      to: { path: '^(scripts|e2e|benchmarks)/' },
    },
    {
      name: 'one-importer-of-planck',
      severity: 'error',
      from: { pathNot: '^packages/simulation/physics/' },
      to: { path: 'node_modules/planck' },
    },
    {
      name: 'one-importer-of-blockly',
      severity: 'error',
      from: { pathNot: '^apps/web/src/features/editor/' },
      to: { path: 'node_modules/blockly' },
    },
    {
      name: 'queries-stand-in-stores',
      comment: 'Kysely is asked in files called …-store.ts, and where databases are opened and migrated.',
      severity: 'error',
      from: {
        path: '^packages/classroom/',
        pathNot: '^packages/classroom/(database/|testing/)|-store\\.ts$|\\.test\\.ts$',
      },
      to: { path: 'node_modules/kysely', dependencyTypesNot: ['type-only'] },
    },
    {
      name: 'one-importer-of-better-auth',
      severity: 'error',
      from: { pathNot: '^packages/classroom/(teaching/accounts\\.ts|.*\\.test\\.ts)$' },
      to: { path: 'node_modules/better-auth' },
    },
    {
      name: 'no-screen-in-packages',
      severity: 'error',
      from: { path: '^packages/' },
      to: { path: 'node_modules/(svelte|@sveltejs|blockly|jsdom)/' },
    },
    {
      name: 'one-reader-of-content',
      comment:
        'Cards, worlds, maps and materials are asked for at @botgarten/content; words have readers of their own.',
      severity: 'error',
      from: { pathNot: '^(packages/content|content)/' },
      to: { path: '^content/', pathNot: '^content/words/' },
    },
    {
      name: 'content-imports-nothing',
      severity: 'error',
      from: { path: '^content/' },
      to: { pathNot: '^content/' },
    },
    ...webRooms.slice(0, -1).map((room, height) => ({
      name: `what-the-web's-${room}-may-know`,
      severity: 'error',
      from: { path: `^apps/web/src/${room}/`, pathNot: testing },
      to: { path: `^apps/web/src/(${webRooms.slice(height + 1).join('|')})/` },
    })),
    {
      name: 'drawing-is-pure',
      severity: 'error',
      from: { path: '^apps/web/src/drawing/', pathNot: testing },
      to: { path: '^apps/web/src/(?!drawing/)|node_modules/svelte' },
    },
    {
      name: 'figures-and-the-lab-do-not-know-each-other',
      severity: 'error',
      from: { path: '^apps/web/src/(figures|lab)/', pathNot: testing },
      to: { path: '^apps/web/src/(figures|lab)/', pathNot: '^apps/web/src/$1/' },
    },
    {
      name: 'features-do-not-know-each-other',
      severity: 'error',
      from: { path: '^apps/web/src/features/([^/]+)/', pathNot: testing },
      to: { path: '^apps/web/src/features/', pathNot: '^apps/web/src/features/$1/' },
    },
    {
      name: 'a-feature-has-one-door',
      severity: 'error',
      from: { path: '^apps/web/src/(app|routes)/' },
      to: { path: '^apps/web/src/features/', pathNot: '^apps/web/src/features/[^/]+/feature\\.ts$' },
    },
    {
      name: 'resolvable',
      severity: 'error',
      from: {},
      // mdast is types alone: the compiler resolves it. `content:…` is what vite.config makes of content/.
      to: { couldNotResolve: true, pathNot: '^(#|\\$|virtual:|content:|\\./\\$types|mdast$)' },
    },
  ],
  options: {
    doNotFollow: { path: 'node_modules' },
    exclude: { path: '(^build/|^apps/[^/]+/build/|/generated/|\\.svelte-kit/)' },
    tsPreCompilationDeps: true,
    tsConfig: { fileName: 'tsconfig.json' },
    enhancedResolveOptions: {
      exportsFields: ['exports'],
      conditionNames: ['import', 'node', 'default', 'types'],
      extensions: ['.ts', '.js', '.mjs', '.svelte'],
    },
  },
}
