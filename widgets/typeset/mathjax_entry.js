// LaTeX to SVG in a bare JavaScript engine: no browser, no files, no network. Bundled by esbuild when the program is
// built. Of TeX's packages only `base` and `ams` are there: nothing that defines macros, loads, links or styles.
import {liteAdaptor} from 'mathjax-full/js/adaptors/liteAdaptor.js';
import {RegisterHTMLHandler} from 'mathjax-full/js/handlers/html.js';
import {TeX} from 'mathjax-full/js/input/tex.js';
import 'mathjax-full/js/input/tex/ams/AmsConfiguration.js';
import {Configuration} from 'mathjax-full/js/input/tex/Configuration.js';
import {CommandMap} from 'mathjax-full/js/input/tex/SymbolMap.js';
import TexError from 'mathjax-full/js/input/tex/TexError.js';
import {mathjax} from 'mathjax-full/js/mathjax.js';
import {SVG} from 'mathjax-full/js/output/svg.js';

// \mark{id}{…}: the SVG group of the term gets the class `mark-id`.
const markMethods = {
  Mark(parser, name) {
    const id = parser.GetArgument(name);
    if (!/^[A-Za-z0-9._-]+$/.test(id))
      throw new TexError('BadMarkId', 'The mark "%1" is not made of letters, digits, ".", "-" and "_"', id);
    let term = parser.ParseArg(name);
    // A node has one class, so a mark around just another mark needs a node of its own.
    if (term.isInferred || term.attributes.getExplicit('class'))
      term = parser.create('node', 'TeXAtom', [term]);
    term.attributes.set('class', 'mark-' + id);
    parser.Push(term);
  },
};
new CommandMap('mark-macros', {mark: 'Mark'}, markMethods);
Configuration.create('mark', {handler: {macro: ['mark-macros']}});

RegisterHTMLHandler(liteAdaptor());
const page = mathjax.document('', {
  InputJax: new TeX({packages: ['base', 'ams', 'mark'], maxMacros: 200, maxBuffer: 8 * 1024}),
  OutputJax: new SVG({fontCache: 'none'}),
});

export function typeset(latex) {
  return page.adaptor.innerHTML(page.convert(latex, {display: true}));
}
