import js from '@eslint/js'
import svelte from 'eslint-plugin-svelte'
import globals from 'globals'
import ts from 'typescript-eslint'
import { promised } from './packages/browsers/promised.ts'
import { newerNames } from './scripts/browsers/support.mjs'

// Their last bits differ between engines (running.md 7); packages/numbers has ours.
const unequalMath =
  'sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp expm1 log log2 log10 log1p pow cbrt hypot random'
    .split(' ')
    .map((property) => ({
      object: 'Math',
      property,
      message: 'Differs between engines: take it from @botgarten/numbers.',
    }))

// Only @botgarten/content reads what lies in content/; words have readers of their own.
const contentFolders =
  '/(?<!#|botgarten\\u002F)content\\u002F(cards|free-lab|maps|materials|questionnaires|things|worlds)(\\u002F|$)/'
const inStores = ['selectFrom', 'insertInto', 'updateTable', 'deleteFrom'].map((name) => ({
  selector: `CallExpression[callee.property.name='${name}']`,
  message: 'Queries stand in the store of their concern (…-store.ts).',
}))
const ofContent = [`Literal[value=${contentFolders}]`, `TemplateElement[value.raw=${contentFolders}]`].map(
  (selector) => ({ selector, message: 'Ask for it at @botgarten/content.' }),
)

const plainHttp = [
  { object: 'crypto', property: 'randomUUID', message: 'Pages over plain http have none: freshId.' },
  { object: 'crypto', property: 'subtle', message: 'Pages over plain http have none.' },
]

// APIs that a promised browser lacks. Members of objects have no names that lint could know: the type checker refuses those of
// JavaScript (`lib` in apps/web/tsconfig.json), `npm run check:browsers` those of the web.
const newer = newerNames(promised)
const lacking = 'A promised browser lacks it (packages/browsers).'

// Rules that ask for types are in .oxlintrc.json: they take seconds there and minutes here.
export default ts.config(
  {
    ignores: [
      // Bundled code of earlier versions.
      'e2e/samples/',
      '**/node_modules/',
      '**/.svelte-kit/',
      'build/',
      'apps/*/build/',
      '**/generated/',
      'pictures/',
      '**/test-results/',
    ],
  },
  js.configs.recommended,
  ...ts.configs.recommended,
  ...svelte.configs.recommended,
  {
    languageOptions: {
      globals: { ...globals.node, ...globals.browser },
    },
    rules: {
      'no-undef': 'off',
      'no-eval': 'error',
      'no-implied-eval': 'error',
      'no-new-func': 'error',
      '@typescript-eslint/no-explicit-any': 'error',
      '@typescript-eslint/no-unused-vars': ['error', { argsIgnorePattern: '^_', varsIgnorePattern: '^_' }],
    },
  },
  { files: ['**/*.svelte', '**/*.svelte.ts'], languageOptions: { parserOptions: { parser: ts.parser } } },
  { ignores: ['packages/content/**'], rules: { 'no-restricted-syntax': ['error', ...ofContent] } },
  {
    files: ['apps/web/src/**/*.{ts,svelte}'],
    rules: { 'no-restricted-properties': ['error', ...plainHttp] },
  },
  {
    files: ['apps/web/src/**/*.{ts,svelte}'],
    ignores: ['**/*.test.ts', '**/testing/**'],
    rules: {
      'no-restricted-properties': [
        'error',
        ...plainHttp,
        ...newer.properties.map((one) => ({ ...one, message: lacking })),
      ],
      'no-restricted-globals': ['error', ...newer.globals.map((name) => ({ name, message: lacking }))],
    },
  },
  {
    files: ['packages/**/*.ts'],
    // The server is where clock, timers and network come from.
    ignores: [
      // Bundled code of earlier versions.
      'e2e/samples/',
      '**/*.test.ts',
      '**/testing/**',
      'packages/server/**',
    ],
    rules: {
      'no-restricted-properties': ['error', ...unequalMath],
      'no-restricted-globals': [
        'error',
        'Date',
        'performance',
        'window',
        'document',
        'setTimeout',
        'setInterval',
        'fetch',
      ],
      // x ** y is Math.pow.
      'no-restricted-syntax': [
        'error',
        { selector: "BinaryExpression[operator='**']", message: 'Differs between engines: multiply.' },
        ...ofContent,
      ],
    },
  },
  {
    files: ['packages/classroom/**/*.ts'],
    ignores: [
      // Bundled code of earlier versions.
      'e2e/samples/',
      '**/*-store.ts',
      '**/database/**',
      '**/*.test.ts',
      '**/testing/**',
    ],
    rules: { 'no-restricted-syntax': ['error', ...inStores, ...ofContent] },
  },
)
