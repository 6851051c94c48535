export default {
  outdir: './src/lib/words/generated',
  strategy: ['baseLocale'],
  outputStructure: 'message-modules',
  emitTsDeclarations: true,
}
