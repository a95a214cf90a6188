// The fragments of diffuse.vert.
FBRDF_FROM_VERTEX vec4 osgFbrdfDiffuse;
FBRDF_COLOUR_OUTPUT

void main()
{
    fbrdfColour = osgFbrdfDiffuse;
}
