export default {
  outdir: './src/lib/words/generated',
  strategy: ['baseLocale'],
  outputStructure: 'locale-modules',
  emitTsDeclarations: true,
}
